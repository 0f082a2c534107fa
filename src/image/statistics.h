#pragma once
#include <span>
#include <vector>

#include "image/film.h"

/// Error bars from replicates: independent estimates of the same image (docs/compare.md).
/// Nothing here assumes that the samples within a replicate are independent.
namespace ajar {

/// A set of replicates: images of equal size, each an unbiased estimate of the same values.
using Replicates = std::vector<std::vector<float>>;

/// A layer of a film that has replicates; `scales[r]` turns the sums of replicate r alone into
/// pixel values (`Integrator::develop_scale`).
struct ScaledLayer {
  int layer;
  std::vector<DevelopScale> scales;
};
/// The replicates of the sum of some layers of a film.
Replicates develop_replicates(const Film& film, std::span<const ScaledLayer> layers);

/// Mean over replicates, value by value.
std::vector<float> replicate_mean(const Replicates& replicates);

/// Median over replicates (of an even number, the lower of the two in the middle), value by value:
/// no firefly of a single one gets into it. Needs R ≥ 1.
std::vector<float> replicate_median(const Replicates& replicates);

/// Standard error of the mean: sqrt(Σ (x_r − mean)² / (R(R − 1))), value by value. Its square is
/// an unbiased estimate of the variance of the mean. Needs R ≥ 2.
std::vector<float> standard_error(const Replicates& replicates);

/// Median of |value| over the values that are neither zero nor infinite; 0 if there are none.
double median_lit(std::span<const float> values);

/// An estimated number with its error bar.
struct Estimate {
  double value;
  double standard_error;
  int degrees_of_freedom;  ///< degrees of freedom of the error bar
};
/// Mean of all values of the image. Its error comes from the replicates' own means, so that
/// correlation between pixels (splats, chains) is accounted for.
Estimate image_mean(const Replicates& replicates);

}  // namespace ajar
