#pragma once
#include <functional>
#include <string>
#include <vector>

#include "core/vector.h"
#include "core/warnings.h"
#include "scene/scene.h"

namespace ajar::bench {

struct BenchScene {
  std::string name;
  std::function<desc::SceneDesc(Warnings&)> load;
};

/// A generated landscape of glass, metal and matte hills (0.5 and 4 million triangles), the
/// built-in scenes, and the shared scenes if their folder is there.
std::vector<BenchScene> bench_scenes();

/// Scenes of `scenes` by name, in the order of the names. Any other name is that of a scene file,
/// and its scene has the file's name without the extension. Raises UsageError for names that are
/// neither.
std::vector<BenchScene> choose_scenes(const std::vector<BenchScene>& scenes,
                                      const std::vector<std::string>& names);

/// The resolution times `factor`, at least 1 pixel each way.
Vec2i scaled_resolution(Vec2i resolution, double factor);
/// The resolution scaled so that its longer side has `long_side` pixels.
Vec2i fitted_resolution(Vec2i resolution, int long_side);

}  // namespace ajar::bench
