#pragma once
#include <cstddef>

namespace ajar {

/// Counts of the scene's objects, for `ajar info` and the statistics.
struct SceneCounts {
  std::size_t triangles = 0;            ///< stored
  std::size_t instanced_triangles = 0;  ///< with every instance counted
  std::size_t quadrics = 0;
  std::size_t curves = 0;  ///< Bézier segments
  std::size_t instances = 0;
  std::size_t lights = 0;
  std::size_t materials = 0;
  std::size_t embree_bytes = 0;
};

}  // namespace ajar
