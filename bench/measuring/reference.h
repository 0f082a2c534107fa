#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace ajar::bench {

/// RelMSE of a picture that the reference's own noise adds.
struct NoiseFloor {
  double plain = 0.0;
  double trimmed = 0.0;  ///< without the worst 0.1 % of pixels
};

/// One long render. Values are scene-linear RGB, row by row.
struct ReferencePart {
  std::vector<float> picture;
  std::vector<float> standard_error;  ///< standard error of each value, from replicates
  std::uint64_t samples = 0;          ///< per pixel
  double cpu_seconds = 0.0;
};

/// Reference picture of comparisons.
struct Reference {
  std::vector<float> picture;
  NoiseFloor floor;
  std::uint64_t samples = 0;  ///< per pixel, of our parts
  double cpu_seconds = 0.0;   ///< CPU time of our parts
  std::size_t parts = 0;
};

/// relMSE that errors of that size have on average. A firefly of the picture counts at most about 1
/// for its pixel, being measured against its own brightness, so that the plain floor is rather low;
/// the trimmed one does not depend on it.
NoiseFloor noise_floor(std::span<const float> picture, std::span<const float> standard_error);

/// relMSE of a picture without the noise of references.
struct OwnError {
  double plain = 0.0;
  double trimmed = 0.0;  ///< without the 0.1 % of the pixels that differ most from the references
};

/// Mean of (a − r₁)(a − r₂)/(r² + 0.01), r being the mean of the references r₁ and r₂. Their noise
/// is in no square, so that it adds nothing on average, if all three pictures are independent. The
/// hundredth of the pixels in which the references differ most is left out, whatever the picture is
/// there; that leaves a twenty-fifth of the squared noise of one reference in the error. Raises
/// std::invalid_argument if they have not as many values, by threes.
OwnError own_error(std::span<const float> picture, std::span<const float> first,
                   std::span<const float> second);

/// Two independent references of equal composition.
struct ReferencePair {
  std::array<std::vector<float>, 2> halves;
  std::vector<float> mean;  ///< mean of both
  NoiseFloor floor;         ///< noise floor of the mean, from the difference of the halves
  double error = 0.0;       ///< error of the mean, as `relative_error` has it; 0 if all is black
};

/// By methods that fail in different places. Each has made two pictures, with seeds of their own;
/// `by_method[m][h]` goes into half h. Methods are weighted by how little their two pictures
/// differ, both halves alike: one that misses light, or has it as fireflies, counts little in
/// either. Raises std::invalid_argument if there is none, or for pictures of different sizes.
ReferencePair reference_pair(std::span<const std::array<std::vector<float>, 2>> by_method);

/// Mean of independent renders by one method, weighted by samples. There must be at least one.
Reference average(std::span<const ReferencePart> parts);

/// Averages `reference` with an independent picture of unknown noise. The noise is estimated from
/// their difference beyond the reference's own; weights are inverse to the trimmed floors.
Reference average_with(const Reference& reference, std::span<const float> independent);

}  // namespace ajar::bench
