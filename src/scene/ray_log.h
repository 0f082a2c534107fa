#pragma once
#include <vector>

#include "scene/ray.h"

namespace ajar {

/// The rays of a render, in the order they were traced, for the limit ratio of the benchmarks. One
/// thread only.
struct RayLog {
  struct Entry {
    Ray ray;
    bool occlusion;  ///< any hit instead of the nearest
  };
  std::vector<Entry> entries;
};

}  // namespace ajar
