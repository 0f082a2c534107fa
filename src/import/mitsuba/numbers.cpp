#include "import/mitsuba/numbers.h"

#include <charconv>
#include <cmath>

#include "color/srgb.h"
#include "import/mitsuba/names.h"

namespace ajar::mitsuba {
namespace {

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

template <typename T>
std::optional<T> parse(std::string_view text) {
  text = trimmed(text);
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<Vec3d> parse_hexadecimal(std::string_view text) {
  if (text.size() != 7) return std::nullopt;
  unsigned code = 0;
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + 7, code, 16);
  if (error != std::errc() || end != text.data() + 7) return std::nullopt;
  return Vec3d(code >> 16U, (code >> 8U) & 255U, code & 255U) / 255.0;
}

}  // namespace

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    if (i < text.size() && text[i] != ',' && !is_space(text[i])) continue;
    if (i > begin) words.push_back(text.substr(begin, i - begin));
    begin = i + 1;
  }
  return words;
}

std::optional<double> parse_number(std::string_view text) {
  const std::optional<double> value = parse<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<long long> parse_integer(std::string_view text) { return parse<long long>(text); }

std::optional<bool> parse_boolean(std::string_view text) {
  const std::string word = lower_case(trimmed(text));
  if (word == "true") return true;
  if (word == "false") return false;
  return std::nullopt;
}

std::optional<std::vector<double>> parse_numbers(std::string_view text) {
  std::vector<double> numbers;
  for (const std::string_view word : words_of(text)) {
    const std::optional<double> number = parse_number(word);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

std::optional<Vec3d> parse_triple(std::string_view text) {
  text = trimmed(text);
  if (!text.empty() && text.front() == '#') return parse_hexadecimal(text);
  const std::optional<std::vector<double>> n = parse_numbers(text);
  if (!n) return std::nullopt;
  if (n->size() == 1) return Vec3d((*n)[0]);
  if (n->size() == 3) return Vec3d((*n)[0], (*n)[1], (*n)[2]);
  return std::nullopt;
}

Vec3d srgb_to_linear(const Vec3d& srgb) {
  return {linear_from_srgb(srgb.x), linear_from_srgb(srgb.y), linear_from_srgb(srgb.z)};
}

}  // namespace ajar::mitsuba
