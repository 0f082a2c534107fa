#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "integrator/integrator.h"
#include "measuring/bench_scenes.h"

namespace ajar::bench {

/// Where references of `measure_scene` are kept unless told otherwise.
inline constexpr const char* kKeptReferences = "build/measured-scenes";

/// A scene at 160×120 pixels with its own filter, and what a picture of it should be.
struct MeasuredScene {
  std::string name;
  desc::SceneDesc description;
  std::unique_ptr<Scene> scene;  ///< built of it
  RenderSettings settings;
  std::vector<float> truth;
  double truth_error = 0.0;  ///< `relative_error` of its own noise
};

/// Its truth is the average of references by two methods that fail in different places, bdpt and
/// mmlt, weighted by how noisy they are as a whole. They are loaded from `folder`, or rendered for
/// `cpu_seconds` together and kept there. Empty if interrupted. Raises IoError.
std::optional<MeasuredScene> measure_scene(const BenchScene& bench_scene, const std::string& folder,
                                           double cpu_seconds);

}  // namespace ajar::bench
