#pragma once
#include "path/raster_area.h"
#include "transport/counted_depth.h"

namespace ajar {

/// Bounds of paths that may be made.
struct PathBounds {
  RasterArea area;
  int min_depth = 1;  ///< edges, at least 1
  int max_depth = 1;
  CountedDepth counted{};  ///< in addition
};

}  // namespace ajar
