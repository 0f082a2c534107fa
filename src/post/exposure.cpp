#include "post/exposure.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "color/color.h"
#include "post/heuristics.h"

namespace ajar {

namespace {

constexpr int kBlocksAlong = PostHeuristics::kExposureBlocks;
constexpr double kMiddleGrey = 0.18;
constexpr double kBrightest = 1e30;  // in place of infinity

constexpr float kWhite = 254.5F / 255.F;
constexpr float kBlack = 6.5F / 255.F;

/// Luminance. Written so that NaN becomes zero.
double light_of(const float* rgb) {
  const double y = luminance(Spectrum(rgb[0], rgb[1], rgb[2]));
  return y > 0.0 ? std::min(y, kBrightest) : 0.0;
}

/// Luminances of the blocks that have light, in ascending order.
std::vector<double> block_luminances(std::span<const float> rgb, Vec2i size) {
  const int side = (std::max(size.x, size.y) + kBlocksAlong - 1) / kBlocksAlong;
  std::vector<double> means;
  for (int y0 = 0; y0 < size.y; y0 += side) {
    for (int x0 = 0; x0 < size.x; x0 += side) {
      double sum = 0.0;
      const int x1 = std::min(x0 + side, size.x);
      const int y1 = std::min(y0 + side, size.y);
      for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) {
          sum += light_of(&rgb[3 * (static_cast<std::size_t>(y) * size.x + x)]);
        }
      }
      if (sum > 0.0) means.push_back(sum / ((x1 - x0) * (y1 - y0)));
    }
  }
  std::sort(means.begin(), means.end());
  return means;
}

}  // namespace

float fitting_exposure(std::span<const float> rgb, Vec2i size) {
  const std::vector<double> blocks = block_luminances(rgb, size);
  if (blocks.empty()) return 0.F;
  const auto stops_of = [&](double share) {
    return std::log2(
        blocks[static_cast<std::size_t>(share * static_cast<double>(blocks.size() - 1))]);
  };
  const double stops =
      std::min(std::log2(kMiddleGrey) - stops_of(0.5), -stops_of(PostHeuristics::kBelowWhite));
  const double rounded = std::round(10.0 * stops) / 10.0;
  return std::clamp(static_cast<float>(rounded), -kMostStops, kMostStops);
}

Clipping clipping(std::span<const float> rgb, ToneMap curve, float exposure) {
  std::size_t white = 0;
  std::size_t black = 0;
  for (std::size_t i = 0; i + 2 < rgb.size(); i += 3) {
    const float shown = tone_map(static_cast<float>(light_of(&rgb[i])), curve, exposure);
    white += shown >= kWhite ? 1U : 0U;
    black += shown < kBlack ? 1U : 0U;
  }
  const double pixels = static_cast<double>(rgb.size()) / 3.0;
  if (pixels == 0.0) return {};
  return {static_cast<double>(white) / pixels, static_cast<double>(black) / pixels};
}

}  // namespace ajar
