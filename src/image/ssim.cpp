#include "image/ssim.h"

#include <array>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "image/plane.h"

namespace ajar {

namespace {
constexpr int kRadius = 5;
constexpr double kSigma = 1.5;
constexpr double kMeanConstant = 0.01 * 0.01;      // C1
constexpr double kVarianceConstant = 0.03 * 0.03;  // C2

/// A column of the window's sums: weighted a, r, a², r², a·r.
using Sums = std::array<double, 5>;

void accumulate(Sums& sums, double weight, const Sums& term) {
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += weight * term[i];
}

double similarity(const Sums& mean) {
  const auto [a, r, aa, rr, ar] = mean;
  const double variances = aa - a * a + rr - r * r;
  return (2 * a * r + kMeanConstant) * (2 * (ar - a * r) + kVarianceConstant) /
         ((a * a + r * r + kMeanConstant) * (variances + kVarianceConstant));
}

double grey(std::span<const float> display, std::size_t pixel) {
  const float* rgb = display.data() + 3 * pixel;
  return 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2];
}
}  // namespace

std::optional<double> ssim(std::span<const float> image, std::span<const float> reference,
                           Vec2i size) {
  const auto width = static_cast<std::size_t>(size.x);
  const auto height = static_cast<std::size_t>(size.y);
  if (image.size() != 3 * width * height || reference.size() != image.size()) {
    throw std::invalid_argument("ssim: an image does not have the size");
  }
  constexpr std::size_t kWindow = 2 * kRadius + 1;
  if (width < kWindow || height < kWindow) return std::nullopt;
  std::vector<double> weights = gaussian_weights(kRadius, kSigma);
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& w : weights) w /= total;

  double sum = 0.0;
  for (std::size_t y = 0; y + kWindow <= height; ++y) {
    std::vector<Sums> columns(width, Sums{});
    for (std::size_t dy = 0; dy < kWindow; ++dy) {
      for (std::size_t x = 0; x < width; ++x) {
        const double a = grey(image, (y + dy) * width + x);
        const double r = grey(reference, (y + dy) * width + x);
        accumulate(columns[x], weights[dy], {a, r, a * a, r * r, a * r});
      }
    }
    for (std::size_t x = 0; x + kWindow <= width; ++x) {
      Sums window{};
      for (std::size_t dx = 0; dx < kWindow; ++dx) {
        accumulate(window, weights[dx], columns[x + dx]);
      }
      sum += similarity(window);
    }
  }
  return sum / static_cast<double>((width - kWindow + 1) * (height - kWindow + 1));
}

}  // namespace ajar
