#pragma once
#include <memory>
#include <utility>
#include <vector>

#include "path/recorder.h"
#include "scene/testing/quadrics.h"
#include "transport/sources.h"

/// The smallest scene that has paths of several edges, and its paths.
namespace ajar::testing {

inline constexpr float kIntensity = 5.F;

/// Two disks, one before and one beside the camera at the origin, which looks along +z; a point
/// light between them.
inline std::unique_ptr<Scene> plain_scene() {
  desc::SceneDesc scene;
  desc::Shape& before = scene.shapes.emplace_back();
  before.node = disk_node(3.F, 4.F, 0.F, 360.F);
  desc::Shape& beside = scene.shapes.emplace_back();
  beside.node = disk_node(-2.F, 3.F, 0.F, 360.F);
  beside.to_world.setAxisAngle(Vec3d(0.0, 1.0, 0.0), 1.2);
  desc::Light& light = scene.lights.emplace_back();
  light.node = desc::light_node("point", {{"intensity", Vec3(kIntensity)}});
  light.to_world.setTranslation(Vec3d(0.5, 1.0, 1.0));
  scene.camera.node = desc::PerspectiveCamera{60.F, 0.F, 1e6F, {}, {}};
  scene.film.resolution = {16, 16};
  Warnings warnings;
  return std::make_unique<Scene>(std::move(scene), BuildOptions{}, warnings);
}

inline PathSamplerSettings all_techniques() {
  PathSamplerSettings settings;
  settings.techniques = TechniqueSet::bdpt();
  settings.max_depth = 4;
  return settings;
}

using RecordedPaths = std::vector<std::pair<Path, Technique>>;

class PathCollector final : public PathRecorder {
 public:
  using PathRecorder::PathRecorder;
  void record(const Path& path, const Contribution& contribution) override {
    paths.emplace_back(path, contribution.technique);
  }
  RecordedPaths paths;
};

inline RecordedPaths recorded(const Scene& scene, const PathSamplerSettings& settings,
                              std::uint32_t samples) {
  PathSampler sampler(scene, settings);
  PathCollector collector(scene, settings);
  const Vec2 size(scene.camera().resolution());
  for (std::uint32_t i = 0; i < samples; ++i) {
    IndependentSource source({1, i, 2, i});
    const Vec2 raster = source.get_pair({Stream::Camera, 0, kEmissionDirection}) * size;
    collector.begin(raster);
    sampler.sample(source, raster, collector);
  }
  return std::move(collector.paths);
}

}  // namespace ajar::testing
