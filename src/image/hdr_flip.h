#pragma once
#include <optional>
#include <span>
#include <vector>

#include "core/vector.h"
#include "image/flip.h"

/// ꟻLIP for pictures of high dynamic range: the largest ꟻLIP of each pixel over exposures that show
/// everything from the brightest to the middle luminance of the reference. Source: Andersson et al.
/// 2021, "Visualizing Errors in Rendered High Dynamic Range Images".
namespace ajar {

/// Equally spaced exposures, in stops, the first and the last included.
struct ExposureRange {
  double start = 0;
  double stop = 0;
  int count = 2;
  double at(int i) const { return start + (stop - start) * i / (count - 1); }
};

/// The exposures for a scene-linear reference: the tone curve (ACES, `filmic_curve`) gives 0.85 for
/// the brightest pixel at the start and for the median luminance at the stop; one exposure per
/// stop, at least two. Where more than half of the reference is black the median is that of the
/// lit pixels (ours: the paper leaves it open). Empty for a black reference.
std::optional<ExposureRange> hdr_flip_exposures(std::span<const float> reference);

/// Difference of each pixel, 0…1. Both images are scene-linear RGB; negative values count as 0.
/// Raises std::invalid_argument as `flip_map` does.
std::vector<float> hdr_flip_map(std::span<const float> image, std::span<const float> reference,
                                Vec2i size, const ExposureRange& exposures,
                                double pixels_per_degree = kFlipPixelsPerDegree);

}  // namespace ajar
