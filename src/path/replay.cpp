#include "path/replay.h"

#include "path/recorder.h"

namespace ajar {

namespace {
class FirstOf final : public PathRecorder {
 public:
  FirstOf(const Scene& scene, const PathSamplerSettings& settings, Technique technique)
      : PathRecorder(scene, settings), technique_(technique) {}
  void record(const Path& path, const Contribution& contribution) override {
    if (found || contribution.technique != technique_ || contribution.light_subpath != 0) return;
    found = path;
  }
  std::optional<Path> found;

 private:
  Technique technique_;
};
}  // namespace

std::optional<Path> replay(const Scene& scene, const PathSamplerSettings& settings,
                           SampleSource& numbers, const Vec2& raster, Technique technique) {
  PathSampler sampler(scene, settings);
  FirstOf first(scene, settings, technique);
  first.begin(raster);
  const bool light_alone = !settings.techniques.any(TechniqueClass::Inner);
  if (technique.s >= 2 && light_alone) {
    sampler.sample_light(numbers, first);
  } else {
    sampler.sample(numbers, raster, first);
  }
  return std::move(first.found);
}

std::optional<Path> replay_halves(const Scene& scene, const PathSamplerSettings& settings,
                                  SampleSource& numbers, const Vec2& raster, Technique technique,
                                  RayCounts& rays) {
  PathSampler sampler(scene, settings);
  FirstOf first(scene, settings, technique);
  first.begin(raster);
  const auto [s, t] = technique;
  PathVertex light_end{};
  PathVertex camera_end{};
  if (s == 0) {
    sampler.sample_implicit(numbers, raster, t, first, &first);
  } else if ((t == 1 || sampler.trace_camera_half(numbers, raster, t, camera_end, &first)) &&
             (s == 1 || sampler.trace_light_half(numbers, s, light_end, &first))) {
    sampler.connect_halves(technique, light_end, camera_end, numbers, first);
  }
  rays.add_rays(sampler.ray_counts());
  return std::move(first.found);
}

}  // namespace ajar
