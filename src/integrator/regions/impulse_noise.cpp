#include "integrator/regions/impulse_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "core/parallel_for.h"

namespace ajar {

namespace {

constexpr int kLargestWindow = 5;
using WindowValues = std::array<float, std::size_t{kLargestWindow} * kLargestWindow>;

/// Median of some values, which it reorders; there is at least one.
double median(std::span<float> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return static_cast<double>(*middle);
  return 0.5 * (static_cast<double>(*std::max_element(values.begin(), middle)) +
                static_cast<double>(*middle));
}

/// The values of one channel.
struct Channel {
  Vec2i size;
  std::span<const float> pixels;
  std::size_t channels;
  std::size_t channel;

  float at(int x, int y) const {
    const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
                       static_cast<std::size_t>(x);
    return pixels[pixel * channels + channel];
  }
};

/// |value − median| of a channel at a pixel.
double deviation(const Channel& channel, int x, int y, int radius) {
  const float value = channel.at(x, y);
  if (!std::isfinite(value)) return 0.0;
  WindowValues values{};
  std::size_t count = 0;
  for (int j = std::max(0, y - radius); j <= std::min(channel.size.y - 1, y + radius); ++j) {
    for (int i = std::max(0, x - radius); i <= std::min(channel.size.x - 1, x + radius); ++i) {
      const float neighbour = channel.at(i, j);
      if (std::isfinite(neighbour)) values[count++] = neighbour;
    }
  }
  return std::abs(static_cast<double>(value) - median(std::span(values).first(count)));
}

}  // namespace

Plane impulse_noise(Vec2i size, std::span<const float> pixels, int window) {
  if (window != 3 && window != kLargestWindow) {
    throw std::invalid_argument("impulse noise: the window is 3 or 5 pixels wide");
  }
  Plane noise(size);
  const std::size_t count = noise.values.size();
  if (count == 0 || pixels.empty() || pixels.size() % count != 0) {
    throw std::invalid_argument("impulse noise: the values are not whole pixels of the image");
  }
  const std::size_t channels = pixels.size() / count;
  // Differences of floats can be too large for a float.
  std::vector<double> deviations(count);
  parallel_for(size.y, [&](int y) {
    for (int x = 0; x < size.x; ++x) {
      double largest = 0.0;
      for (std::size_t c = 0; c < channels; ++c) {
        largest = std::max(largest, deviation({size, pixels, channels, c}, x, y, window / 2));
      }
      deviations[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
                 static_cast<std::size_t>(x)] = largest;
    }
  });
  const double largest = *std::max_element(deviations.begin(), deviations.end());
  if (largest > 0.0) {
    std::transform(deviations.begin(), deviations.end(), noise.values.begin(),
                   [=](double value) { return static_cast<float>(value / largest); });
  }
  return noise;
}

}  // namespace ajar
