#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/vector.h"
#include "image/statistics.h"

namespace ajar {

/// The error of a picture as one number, with or without a reference:
///
///     sqrt( mean over values of  (x − t)² / (t² + 0.01 μ²) ),   μ = median of the lit |t|,
///
/// i.e. the square root of relMSE (docs/methods/error-estimate.md) of the picture exposed so that μ
/// is 1. 0.01 is "1 %". Relative per pixel, because ‖error‖/‖picture‖ is decided by a few visible
/// lamps; floored, because dark pixels would have infinite relative error; the floor hangs on the
/// median, because it must depend neither on the units of the scene nor on the lamps.
///
/// Error of a picture with known reference t: all have the same number of values, else
/// std::invalid_argument; nullopt if t is black.
std::optional<double> relative_error(std::span<const float> picture, std::span<const float> truth);

/// Estimate without a reference: (x − t)² is estimated by the squared standard error of replicates,
/// and t by `smoothed_reference`.
struct RelativeError {
  /// A lower bound if `has_fireflies`: relative to a reference that is nowhere darker than the
  /// picture around.
  double value = 0.0;
  /// Over how many places of 4×4 pixels the squared error is spread: (Σ e)² / Σ e².
  double places = 0.0;
  /// The least number of pixels that make half of the squared error, as a share of all.
  double half_of_it = 0.0;
  /// True if so few places dominate that the next path may be as strong as all so far.
  bool has_fireflies = false;
  /// There is light that the method cannot see, however long it renders. (For the caller to say.)
  bool misses_light = false;
  bool is_lower_bound() const { return has_fireflies || misses_light; }
};
/// Estimates the error of a picture of `size` pixels (3 values each, rows from the top); needs R ≥
/// 2 replicates of that size, else std::invalid_argument. Nullopt if it is black. Light that no
/// sample has found is not counted.
std::optional<RelativeError> estimate_relative_error(Replicates replicates, Vec2i size);
struct ErrorAtScale {
  double sigma;  ///< pixels
  double value;
};
/// Pixels.
inline constexpr std::array<double, 4> kErrorScales = {1.0, 2.0, 4.0, 8.0};
/// By scale: the error of the picture after Gaussians of `kErrorScales`. Noise that is independent
/// from pixel to pixel falls with the scale; correlated noise (clumps of chains) does not, and no
/// filter removes it. Raises as above; empty if the picture is black.
std::vector<ErrorAtScale> estimate_errors_by_scale(const Replicates& replicates, Vec2i size);
/// Peak memory of the estimates, bytes per pixel.
std::uint64_t error_estimate_bytes(int replicates);

}  // namespace ajar
