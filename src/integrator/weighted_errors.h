#pragma once
#include <initializer_list>
#include <string>
#include <vector>

#include "image/importance_map.h"
#include "image/statistics.h"
#include "integrator/integrator.h"

namespace ajar {

/// The replicates of the sum of those layers that a film has, after `samples` samples per pixel.
Replicates develop_layers(const Film& film, const Integrator& integrator, std::uint64_t samples,
                          std::initializer_list<std::string> names);

/// What errors of pixels weigh: their luminance times the importance of the pixel.
struct WeightedErrors {
  std::vector<double> variance;  ///< importance² · variance of the mean over replicates
  std::vector<double> light;     ///< importance · mean
};

/// Of each pixel of `crop`. `replicates`: at least two pictures of it, each unbiased.
WeightedErrors weighted_errors(const Replicates& replicates, const Box2i& crop,
                               const ImportanceMap& importance);

}  // namespace ajar
