#pragma once
#include <span>
#include <vector>

#include "path/log_density.h"
#include "path/path.h"
#include "transport/path_sampler.h"

namespace ajar {

/// Contribution and weight of each technique of a sampler's set for one path: all of them together
/// in time linear in the length of the path, where `mis_weight` and `throughput` (measure.h) need
/// that for each.
class TechniqueParts {
 public:
  /// For samplers with these settings. The scene must outlive it.
  TechniqueParts(const Scene& scene, PathSamplerSettings settings)
      : scene_(scene), settings_(std::move(settings)) {}

  struct Part {
    double weight = 0.0;  ///< MIS weight; 0 if the technique does not make the path
    /// Luminance of the contribution of one try, as `Contribution::value` has it: with its MIS
    /// weight, without its roulette weight.
    double light = 0.0;
  };
  /// Parts of techniques (s, k + 1 − s), for s = 0 … k; valid until the next call. `log_light`: ln
  /// luminance(f), f the `contribution` of the path.
  std::span<const Part> of(const Path& path, double log_light);

 private:
  void find_densities(const Path& path);

  const Scene& scene_;
  PathSamplerSettings settings_;
  // By s, logarithms: no double holds the densities of long paths.
  std::vector<LogDensity> densities_;  ///< tries · density, as MIS weights have it
  std::vector<double> spreads_;        ///< factors of f by deltas that are sampled from the light
  std::vector<Part> parts_;
};

}  // namespace ajar
