#include "session/picture_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ajar {

namespace {

constexpr WarningKind kOutOfRange{Effect::Light,
                                  "pictures have values that floats cannot hold well"};

/// Below this, floats have fewer digits the smaller they are.
constexpr double kLeastNormal = std::numeric_limits<float>::min();
/// A picture as dim as this on average has many values below it, and factors of paths even more.
constexpr double kDimmestMean = 1024.0 * kLeastNormal;

bool has_light(const Film& film) {
  const auto sums = film.raw();
  return std::any_of(sums.begin(), sums.end(), [](std::int64_t sum) { return sum != 0; });
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
  if (film_scale == 0.0 || least >= kDimmestMean || !has_light(film)) return std::nullopt;
  return Warning{
      kOutOfRange,
      {},
      fmt::format("the picture is so dim that floats lose its digits: its mean is {:.2g}, with a "
                  "film's scale "
                  "of {:g}, and below {:.2g} they have fewer; make the lights or the scale larger",
                  mean, film_scale, kLeastNormal)};
}

}  // namespace ajar
