#pragma once
#include <functional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace ajar::bench {

struct BenchScene {
  std::string name;
  std::function<desc::SceneDesc(Warnings&)> load;
};

/// A generated landscape of glass, metal and matte hills (0.5 and 4 million triangles), the
/// built-in scenes, and the shared scenes if their folder is there.
std::vector<BenchScene> bench_scenes();

}  // namespace ajar::bench
