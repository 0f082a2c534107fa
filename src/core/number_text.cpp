#include "core/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

namespace ajar {

namespace {

/// True if a well-formed number outside of the range of double is too large, not too small.
bool is_too_large(std::string_view text) {
  const std::size_t e = text.find_first_of("eE");
  const std::string_view digits = text.substr(0, e);
  long long exponent = 0;
  if (e != std::string_view::npos) {
    const char* first = text.data() + e + 1;
    if (*first == '+') ++first;
    const auto status = std::from_chars(first, text.data() + text.size(), exponent).ec;
    if (status == std::errc::result_out_of_range) return *first != '-';
  }
  const std::size_t point = std::min(digits.find('.'), digits.size());
  const std::size_t leading = digits.find_first_of("123456789");
  if (leading == std::string_view::npos) return false;
  const auto order = static_cast<long long>(point) - static_cast<long long>(leading);
  return exponent > -order;
}

}  // namespace

std::string number_text(double value) {
  constexpr double kAllWholeNumbersUpTo = 9007199254740992.0;
  const bool is_whole = std::trunc(value) == value && std::abs(value) < kAllWholeNumbersUpTo;
  return is_whole ? fmt::format("{:.0f}", value) : fmt::format("{:g}", value);
}

std::string percent_text(double share) {
  const double percent = 100.0 * share;
  return percent < 99.5 ? fmt::format("{:.2g} %", percent) : fmt::format("{:.0f} %", percent);
}

std::optional<double> number_of(std::string_view text) {
  // std::from_chars takes no sign in front but a minus.
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0.0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size() || status == std::errc::invalid_argument) {
    return std::nullopt;
  }
  if (status == std::errc()) return value;
  const double size = is_too_large(text) ? std::numeric_limits<double>::infinity() : 0.0;
  return text[0] == '-' ? -size : size;
}

double decimal_of(float value) {
  return std::isfinite(value) ? *number_of(fmt::format("{}", value)) : value;
}

}  // namespace ajar
