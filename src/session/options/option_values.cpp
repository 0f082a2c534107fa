#include "session/options/option_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "session/options/limits.h"

namespace ajar {

namespace {

[[noreturn]] void reject(const std::string& option, std::string_view text,
                         const std::string& expected) {
  throw UsageError(option + " expects " + expected + ", not \"" + std::string(text) + "\"");
}

/// Reads a number at the front of `text` and removes it.
template <typename Number>
std::optional<Number> take_number(std::string_view& text) {
  Number value{};
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

template <typename Number>
std::optional<Number> whole_text_number(std::string_view text) {
  const std::optional<Number> value = take_number<Number>(text);
  return text.empty() ? value : std::nullopt;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t at = text.find(separator);
    parts.push_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

template <typename Whole>
Whole whole_within(const std::string& option, std::string_view text, const Limits<Whole>& limits) {
  const auto value = whole_text_number<Whole>(text);
  if (!value || !limits.contain(*value)) reject(option, text, "a whole number " + limits.text());
  return *value;
}

double seconds_per_unit(char unit) {
  switch (unit) {
    case 's':
      return 1.0;
    case 'm':
      return 60.0;
    case 'h':
      return 3600.0;
    case 'd':
      return 86400.0;
    default:
      return 0.0;
  }
}

}  // namespace

double parse_duration(const std::string& option, std::string_view text) {
  const std::string expected =
      "a time above zero, at most thirty years, such as 60, 60s, 2m or 1h30m";
  double seconds = 0.0;
  std::string_view rest = text;
  if (rest.empty()) reject(option, text, expected);
  while (!rest.empty()) {
    const std::optional<double> value = take_number<double>(rest);
    if (!value || !std::isfinite(*value) || *value < 0.0) reject(option, text, expected);
    if (rest.empty()) {
      // Only a number that stands alone may go without a unit: 1h30 could mean two things.
      if (seconds > 0.0) reject(option, text, expected);
      seconds = *value;
      break;
    }
    const double unit = seconds_per_unit(rest.front());
    if (unit == 0.0) reject(option, text, expected);
    rest.remove_prefix(1);
    seconds += *value * unit;
  }
  if (!limits::kSeconds.contain(seconds)) reject(option, text, expected);
  return seconds;
}

int parse_whole(const std::string& option, std::string_view text, const Limits<int>& limits) {
  return whole_within(option, text, limits);
}

std::uint64_t parse_whole(const std::string& option, std::string_view text,
                          const Limits<std::uint64_t>& limits) {
  return whole_within(option, text, limits);
}

double parse_number(const std::string& option, std::string_view text, const std::string& what,
                    const Limits<double>& limits) {
  const auto value = whole_text_number<double>(text);
  if (!value || !limits.contain(*value)) {
    reject(option, text, fmt::format("a number of {} {}", what, limits.text()));
  }
  return *value;
}

Exposure parse_exposure(const std::string& option, std::string_view text) {
  if (text == "auto") return {.automatic = true};
  const auto stops = whole_text_number<float>(text);
  if (!stops || !limits::kStops.contain(*stops)) {
    reject(option, text, fmt::format("a number of stops {}, or auto", limits::kStops.text()));
  }
  return {.stops = *stops};
}

double parse_relative_error(const std::string& option, std::string_view text) {
  const bool is_percent = text.ends_with('%');
  const auto value = whole_text_number<double>(is_percent ? text.substr(0, text.size() - 1) : text);
  const double error = value.value_or(0.0) * (is_percent ? 0.01 : 1.0);
  if (limits::kRelativeError.contain(error)) return error;
  std::string expected = "a relative error above 0 and at most 1, such as 0.05 or 5%";
  if (!is_percent && error > 1.0 && error <= 100.0) {
    expected += fmt::format(" (did you mean {:g}, or {:g}%?)", 0.01 * error, error);
  }
  reject(option, text, expected);
}

TargetError parse_target_error(const std::string& option, std::string_view text) {
  constexpr std::string_view kDenoised = "denoised:";
  const bool is_denoised = text.starts_with(kDenoised);
  if (is_denoised) text.remove_prefix(kDenoised.size());
  if (text.find(':') != std::string_view::npos) {
    reject(option, text, "a relative error such as 5%, or of the denoised picture: denoised:5%");
  }
  return {parse_relative_error(option, text), is_denoised};
}

Vec2i parse_resolution(const std::string& option, std::string_view text) {
  const std::string expected = "WIDTHxHEIGHT in pixels (1 to 65536 each) such as 640x480";
  const std::vector<std::string_view> parts = split(text, 'x');
  if (parts.size() != 2) reject(option, text, expected);
  const auto width = whole_text_number<int>(parts[0]);
  const auto height = whole_text_number<int>(parts[1]);
  if (!width || !height || !limits::kResolution.contain(*width) ||
      !limits::kResolution.contain(*height)) {
    reject(option, text, expected);
  }
  return {*width, *height};
}

DepthRange parse_depth(const std::string& option, std::string_view text) {
  const std::string expected =
      "MIN:MAX in path edges, 1 <= MIN <= MAX <= 1000, such as 1:8 (1 is light seen directly)";
  const std::vector<std::string_view> parts = split(text, ':');
  if (text.empty() || text == ":" || parts.size() > 2) reject(option, text, expected);
  const auto edges = [&](std::string_view part) -> std::optional<int> {
    if (part.empty()) return std::nullopt;
    const auto value = whole_text_number<int>(part);
    if (!value || !limits::kDepth.contain(*value)) reject(option, text, expected);
    return value;
  };
  DepthRange range;
  if (parts.size() == 2) range.minimum = edges(parts[0]);
  range.maximum = edges(parts.back());
  if (range.minimum && range.maximum && *range.minimum > *range.maximum) {
    reject(option, text, expected);
  }
  return range;
}

CropWindow parse_crop(const std::string& option, std::string_view text) {
  const std::string expected =
      "x0,y0,x1,y1 in pixels, or in fractions of the picture (then all four at most 1)";
  const std::vector<std::string_view> parts = split(text, ',');
  if (parts.size() != 4) reject(option, text, expected);
  CropWindow crop;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto value = whole_text_number<double>(parts[i]);
    if (!value || !std::isfinite(*value) || *value < 0.0 || *value > kMaxResolution) {
      reject(option, text, expected);
    }
    crop.values[i] = *value;
    crop.fractions = crop.fractions && *value <= 1.0;
  }
  const auto& v = crop.values;
  const bool whole = std::all_of(v.begin(), v.end(), [](double x) { return x == std::floor(x); });
  if (!crop.fractions && !whole) reject(option, text, expected);
  if (!(v[0] < v[2]) || !(v[1] < v[3])) reject(option, text, expected + ", x0 < x1 and y0 < y1");
  return crop;
}

Box2i crop_pixels(const std::string& option, const CropWindow& crop, Vec2i resolution) {
  const auto pixel = [&](std::size_t i, int size) {
    const double value = crop.fractions ? std::ceil(crop.values[i] * size) : crop.values[i];
    return std::clamp(static_cast<int>(value), 0, size);
  };
  const Vec2i min(pixel(0, resolution.x), pixel(1, resolution.y));
  const Vec2i max(pixel(2, resolution.x) - 1, pixel(3, resolution.y) - 1);
  if (max.x < min.x || max.y < min.y) {
    throw UsageError(option + ": no pixel of the " + std::to_string(resolution.x) + "x" +
                     std::to_string(resolution.y) + " picture lies in the window");
  }
  return {min, max};
}

WorkSlice parse_share(const std::string& option, std::string_view text) {
  const std::string expected = "K/N, the K-th of N shares, such as 3/8";
  const std::vector<std::string_view> parts = split(text, '/');
  if (parts.size() != 2) reject(option, text, expected);
  const auto number = whole_text_number<std::uint64_t>(parts[0]);
  const auto count = whole_text_number<std::uint64_t>(parts[1]);
  if (!number || !count || *number < 1 || *count > kMostShares || *number > *count) {
    reject(option, text, expected);
  }
  return {*number - 1, *count};
}

std::map<std::string, std::string> parse_assignments(const std::string& option,
                                                     const std::vector<std::string>& texts) {
  std::map<std::string, std::string> values;
  for (const std::string& text : texts) {
    const std::size_t at = text.find('=');
    if (at == std::string::npos || at == 0) reject(option, text, "KEY=VALUE");
    values[text.substr(0, at)] = text.substr(at + 1);
  }
  return values;
}

std::vector<std::string> parse_list(std::string_view text) {
  std::vector<std::string> names;
  for (const std::string_view part : split(text, ',')) {
    std::string name(part);
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) {
      names.push_back(std::move(name));
    }
  }
  return names;
}

}  // namespace ajar
