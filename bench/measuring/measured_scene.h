#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "integrator/integrator.h"
#include "measuring/bench_scenes.h"
#include "measuring/reference.h"

namespace ajar::bench {

/// How scenes are measured.
struct MeasureOptions {
  int longer_side = 0;      ///< pixels, in the scene's own shape; 0: 160×120 for all
  bool box_filter = false;  ///< one pixel wide, instead of the scene's own
  std::string folder = "build/measured-scenes";  ///< where references are kept
  double reference_seconds = 400.0;              ///< of CPU, of both methods together
};

/// A scene, and what a picture of it should be.
struct MeasuredScene {
  std::string name;
  desc::SceneDesc description;
  std::unique_ptr<Scene> scene;  ///< built of it
  RenderSettings settings;
  /// By one method each, independent of one another.
  std::array<std::vector<float>, 2> references;
  std::vector<float> truth;  ///< their average
  double truth_error = 0.0;  ///< `relative_error` of its own noise
  NoiseFloor truth_floor;    ///< what that noise alone adds to the relMSE of a picture
};

/// Its truth is the average of references by two methods that fail in different places, bdpt and
/// mmlt+, weighted by how noisy they are as a whole. They are loaded from the folder, or rendered
/// and kept there. Empty if interrupted. Raises IoError.
std::optional<MeasuredScene> measure_scene(const BenchScene& bench_scene,
                                           const MeasureOptions& options);

}  // namespace ajar::bench
