#include "session/output/picture_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ajar {

namespace {

constexpr WarningKind kOutOfRange{Effect::Light,
                                  "pictures have values that floats cannot hold well"};

constexpr WarningKind kBlack{Effect::Light, "pictures are black"};

/// Below this, floats have fewer digits the smaller they are.
constexpr double kLeastNormal = std::numeric_limits<float>::min();
/// A picture as dim as this on average has many values below it, and factors of paths even more.
constexpr double kDimmestMean = 1024.0 * kLeastNormal;

/// Also of what the floats of a picture cannot hold.
bool has_light(const Film& film) {
  constexpr double kMakesLarge = 1e30;
  for (std::size_t i = 0; i < film.layers().size(); ++i) {
    const LayerSpec& spec = film.layers()[i];
    const std::string& name = spec.part_of.empty() ? spec.name : spec.part_of;
    if (name != "direct" && name != "indirect") continue;
    const std::vector<float> values = film.develop(static_cast<int>(i), kMakesLarge);
    if (std::any_of(values.begin(), values.end(), [](float value) { return value != 0.F; })) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::optional<Warning> range_complaint(const Film& film, const Picture& picture,
                                       double film_scale) {
  std::size_t infinite = 0;
  double sum = 0.0;
  const std::vector<float>& values = picture.layers.front().pixels;
  for (const float value : values) {
    if (std::isfinite(value)) {
      sum += std::abs(static_cast<double>(value));
    } else {
      ++infinite;
    }
  }
  if (infinite > 0) {
    return Warning{
        kOutOfRange,
        {},
        fmt::format(
            "{} of {} values of the picture are infinite: light times the film's scale of {:g} is "
            "beyond the largest float, 3.4e38; make the scale or the lights smaller",
            infinite, values.size(), film_scale)};
  }
  const double mean = sum / static_cast<double>(values.size());
  // Before the scale, too: what is lost in the light does not come back with it.
  const double least = std::min(mean, film_scale != 0.0 ? mean / std::abs(film_scale) : mean);
  if (film_scale == 0.0) return std::nullopt;
  if (sum == 0.0 && !has_light(film)) {
    return Warning{kBlack,
                   {},
                   "the picture is black: no path has found light; see whether the lights reach "
                   "what the camera sees, and try a larger --depth, more samples or another "
                   "method"};
  }
  if (least >= kDimmestMean || !has_light(film)) return std::nullopt;
  return Warning{
      kOutOfRange,
      {},
      fmt::format("the picture is so dim that floats lose its digits: its mean is {:.2g}, with a "
                  "film's scale "
                  "of {:g}, and below {:.2g} they have fewer; make the lights or the scale larger",
                  mean, film_scale, kLeastNormal)};
}

}  // namespace ajar
