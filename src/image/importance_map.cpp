#include "image/importance_map.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "image/heuristics.h"

namespace ajar {

namespace {

constexpr int kBlurRadius = ImageHeuristics::kImportanceBlur;

double mean_of(const std::vector<float>& values) {
  double sum = 0.0;
  for (const float value : values) {
    if (std::isfinite(value) && value > 0.F) sum += static_cast<double>(value);
  }
  return sum / static_cast<double>(values.size());
}

/// Mean of a window along one axis; called for both axes, twice, it comes close to a Gaussian.
std::vector<float> blur_axis(const std::vector<float>& in, int width, int height, bool horizontal) {
  std::vector<float> out(in.size());
  const int length = horizontal ? width : height;
  const int lines = horizontal ? height : width;
  for (int line = 0; line < lines; ++line) {
    const auto at = [&](int i) {
      const int x = horizontal ? i : line;
      const int y = horizontal ? line : i;
      return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
             static_cast<std::size_t>(x);
    };
    for (int i = 0; i < length; ++i) {
      const int first = std::max(0, i - kBlurRadius);
      const int last = std::min(length - 1, i + kBlurRadius);
      double sum = 0.0;
      for (int j = first; j <= last; ++j) sum += static_cast<double>(in[at(j)]);
      out[at(i)] = static_cast<float>(sum / (last - first + 1));
    }
  }
  return out;
}

}  // namespace

ImportanceMap::ImportanceMap(const Box2i& pixels, std::vector<float> weights, float floor)
    : pixels_(pixels), weights_(std::move(weights)) {
  const int width = pixels.max.x - pixels.min.x + 1;
  const int height = pixels.max.y - pixels.min.y + 1;
  if (weights_.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
    throw std::invalid_argument("importance map: the number of weights is not that of the pixels");
  }
  const double mean = mean_of(weights_);
  if (!(mean > 0.0) || !std::isfinite(mean)) {
    throw std::invalid_argument("importance map: no weight is above zero");
  }
  for (float& weight : weights_) {
    const double scaled = std::isfinite(weight) ? static_cast<double>(weight) / mean : 0.0;
    weight = std::max(floor, static_cast<float>(scaled));
  }
}

ImportanceMap ImportanceMap::relative(const Box2i& pixels, std::vector<float> luminances) {
  const int width = pixels.max.x - pixels.min.x + 1;
  const int height = pixels.max.y - pixels.min.y + 1;
  const double mean = mean_of(luminances);
  if (!(mean > 0.0)) return {};
  // Only ratios count. A power of two changes no digit of them, and keeps the inverses within the
  // range of floats however dim or bright the picture is.
  const double unit = std::exp2(std::ilogb(mean));
  for (float& value : luminances) {
    const double scaled = static_cast<double>(value) / unit;
    value = std::isfinite(value) ? static_cast<float>(std::clamp(
                                       scaled, 0.0, ImageHeuristics::kMostLuminance * mean / unit))
                                 : 0.F;
  }
  for (int pass = 0; pass < 2; ++pass) {
    luminances = blur_axis(luminances, width, height, true);
    luminances = blur_axis(luminances, width, height, false);
  }
  const double delta = ImageHeuristics::kImportanceDelta * mean_of(luminances);
  for (float& value : luminances) {
    value = static_cast<float>(1.0 / (static_cast<double>(value) + delta));
  }
  return {pixels, std::move(luminances)};
}

}  // namespace ajar
