#include "core/number_text.h"

#include <fmt/format.h>

#include <cmath>

namespace ajar {

std::string number_text(double value) {
  constexpr double kAllWholeNumbersUpTo = 9007199254740992.0;
  const bool is_whole = std::trunc(value) == value && std::abs(value) < kAllWholeNumbersUpTo;
  return is_whole ? fmt::format("{:.0f}", value) : fmt::format("{:g}", value);
}

std::string percent_text(double share) {
  const double percent = 100.0 * share;
  return percent < 99.5 ? fmt::format("{:.2g} %", percent) : fmt::format("{:.0f} %", percent);
}

}  // namespace ajar
