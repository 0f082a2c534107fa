#pragma once
#include <cstdint>
#include <initializer_list>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "image/importance_map.h"
#include "image/statistics.h"
#include "integrator/integrator.h"

namespace ajar {

/// The replicates of the sum of those layers that a film has, after `samples` samples per pixel.
Replicates develop_layers(const Film& film, const Integrator& integrator, std::uint64_t samples,
                          std::initializer_list<std::string> names);

/// Luminance · importance of each pixel of `crop`, picture by picture.
std::vector<std::vector<float>> weighted_light(const Replicates& replicates, const Box2i& crop,
                                               const ImportanceMap& importance);

/// Errors of pixels, weighted: their luminance times the importance of the pixel.
struct WeightedErrors {
  std::vector<double> variance;  ///< importance² · variance of the mean over replicates
  std::vector<double> light;     ///< importance · mean
  /// importance² · variance of a single one of these samples.
  std::vector<double> of_sample(std::uint64_t samples) const;
};

/// Errors of each pixel of `crop`. `replicates`: at least two pictures of it, each unbiased.
WeightedErrors weighted_errors(const Replicates& replicates, const Box2i& crop,
                               const ImportanceMap& importance);

/// Importance that equalises relative errors; constant where all is black.
ImportanceMap relative_importance(const Replicates& replicates, const Box2i& crop);

/// Variance of the mean over pictures, of which there must be two, value by value.
std::vector<double> variance_of_mean(std::span<const std::vector<float>> pictures);

/// With 0 in the worst 0.1 % of pixels, as errors are measured (bench/): a few fireflies on one
/// side, or a chain that was stuck for long on the other, would decide for the whole picture.
std::vector<double> trimmed(std::vector<double> variance);

inline double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

}  // namespace ajar
