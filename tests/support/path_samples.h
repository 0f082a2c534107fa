#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include "mcmc/path_space/make_path_mutations.h"
#include "path/recorder.h"
#include "scene/scene.h"
#include "transport/sources.h"

namespace ajar::test {

/// Edges of the paths below, at most.
inline constexpr int kPathSampleDepth = 6;

/// Bounds for mutations of them.
inline PathBounds path_sample_bounds(const Scene& scene) {
  return {{Vec2(0.F), Vec2(scene.camera().resolution())}, 1, kPathSampleDepth};
}

struct WeightedPath {
  Path path;
  double weight;  ///< luminance of its contribution
};

/// All paths of a sample of bidirectional path tracing.
class PathCollector final : public PathRecorder {
 public:
  using PathRecorder::PathRecorder;
  void record(const Path& path, const Contribution& contribution) override {
    const auto weight = static_cast<double>(luminance(contribution.value));
    if (weight > 0.0 && std::isfinite(weight)) paths.push_back({path, weight});
  }
  std::vector<WeightedPath> paths;
};

/// Calls `each(number, paths)` for each sample: in proportion to their weights, paths are
/// distributed as light is.
template <typename Each>
void for_samples(const Scene& scene, std::uint32_t samples, const Each& each) {
  PathSamplerSettings settings;
  settings.techniques = TechniqueSet::bdpt();
  settings.max_depth = kPathSampleDepth;
  settings.roulette_start = kPathSampleDepth + 1;
  PathSampler sampler(scene, settings);
  PathCollector collector(scene, settings);
  const Vec2 size(scene.camera().resolution());
  for (std::uint32_t i = 0; i < samples; ++i) {
    IndependentSource source({7, i, 8, i});
    const Vec2 raster = source.get_pair({Stream::Camera, 0, kEmissionDirection}) * size;
    collector.paths.clear();
    collector.begin(raster);
    sampler.sample(source, raster, collector);
    each(i, collector.paths);
  }
}

}  // namespace ajar::test
