#pragma once
#include <span>
#include <vector>

#include "image/plane.h"
#include "image/regions.h"

namespace ajar {

/// Conversion of noise to the binary map σ of `selective`; the defaults are those published.
struct RegionMapSettings {
  int window = 3;          ///< window of the noise: 3 or 5 pixels
  float threshold = 0.5F;  ///< T: noise from here on asks for chains
  float epsilon = 0.1F;    ///< ε: σ where no chains are needed; above 0 ties both halves together
};

/// The noise of a region, of its pixels at or above T alone; all are 0 if there are none.
struct RegionNoise {
  std::uint32_t pixels = 0;  ///< number of pixels
  float mean = 0.F;
  float largest = 0.F;
  /// Value that fills the region: ½(mean + largest).
  float fill() const { return 0.5F * (mean + largest); }
};

/// Noise per region, after Frolov (below). Raises std::invalid_argument if the noise is of
/// a picture of another size.
///
/// "Values above T" are taken to include T itself, as the threshold S(x) = ε if x < T does; and the
/// mean is that of those values, not of all pixels of the region, so that one outlier decides for
/// its object however large that is. Noise that is not a number is below T.
std::vector<RegionNoise> aggregate_noise(const Plane& noise, const Regions& regions,
                                         float threshold);

/// Steps 5 and 8: σ of each region, ε or 1, by S(x) = ε if x < T, else 1.
///
/// The published list puts S before the regions (step 5), where it applies to pixels; but then all
/// values above T are 1, and neither mean nor maximum is left to take. We aggregate the noise
/// itself and apply S to the fill. Both orders give the same map: a region is 1 if any of its
/// pixels reaches T, for ½(mean + largest) is then at least T, and ε else. Where T ≤ 0, S holds for
/// regions without noise, too.
std::vector<float> threshold_map(std::span<const RegionNoise> noise,
                                 const RegionMapSettings& settings);

/// Steps 2 to 8 at once: σ of each region from the indirect light of an ordinary Monte Carlo render
/// of few samples (`indirect`: row by row, channels side by side).
///
/// Source: Frolov, "Selective application of Metropolis Light Transport for hard sampling
/// illumination phenomena" (docs/methods/selective.md).
std::vector<float> region_map(std::span<const float> indirect, const Regions& regions,
                              const RegionMapSettings& settings);

}  // namespace ajar
