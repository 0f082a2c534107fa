#pragma once
#include <vector>

#include "core/vector.h"
#include "image/heuristics.h"
#include "image/pixel_at.h"

namespace ajar {

/// A positive weight per pixel that a Markov chain multiplies into its target and divides out of
/// its splats (docs/methods/divided-light.md): where it is large, the chain spends more of its
/// time, while the picture's expectation does not change. Piecewise constant; weights beyond the
/// border are those of the nearest pixel.
class ImportanceMap {
 public:
  /// Constant weight.
  ImportanceMap() = default;
  /// Row by row over `pixels` (min and max inclusive). Weights are scaled to a mean of 1; those
  /// below `floor` times the mean, or not finite, are raised to that, because a pixel of weight
  /// zero would stay black. Raises std::invalid_argument if the sizes differ or no weight is
  /// positive.
  ImportanceMap(const Box2i& pixels, std::vector<float> weights,
                float floor = ImageHeuristics::kImportanceFloor);

  /// Weight of the pixel that a raster position lies in.
  float operator()(const Vec2& raster) const {
    return weights_.empty() ? 1.F : weights_[pixel_at(pixels_, raster)];
  }

  /// Equalises relative error: weight ∝ 1 / (luminance + δ), δ a share of the mean luminance
  /// (Veach 1997, section 11.3.2, "two-stage Metropolis"). `luminances` may be noisy: they are
  /// blurred first.
  static ImportanceMap relative(const Box2i& pixels, std::vector<float> luminances);

 private:
  Box2i pixels_;
  std::vector<float> weights_;
};

}  // namespace ajar
