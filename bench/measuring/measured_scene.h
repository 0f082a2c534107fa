#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "integrator/integrator.h"
#include "measuring/bench_scenes.h"
#include "measuring/reference.h"

namespace ajar::bench {

/// Conditions of measurements.
struct MeasureOptions {
  int longer_side = 0;      ///< pixels, in the scene's own shape; 0: 160×120 for all
  bool box_filter = false;  ///< one pixel wide, instead of the scene's own
  std::string folder = "build/measured-scenes";  ///< where references are kept
  double reference_seconds = 400.0;              ///< CPU time of all that is rendered
  /// Methods of references, which fail in different places.
  std::vector<std::string> reference_methods = {"bdpt", "selective"};
};

/// A scene, and its reference picture.
struct MeasuredScene {
  std::string name;
  desc::SceneDesc description;
  std::unique_ptr<Scene> scene;  ///< built of it
  RenderSettings settings;
  ReferencePair references;
};

/// References are loaded from the folder, or rendered and kept there: two pictures by each method,
/// with seeds of their own. Empty if interrupted. Raises IoError.
std::optional<MeasuredScene> measure_scene(const BenchScene& bench_scene,
                                           const MeasureOptions& options);

}  // namespace ajar::bench
