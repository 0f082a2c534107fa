#pragma once
#include "core/vector.h"
#include "path/path.h"

namespace ajar {

/// Factor of the light on paths in the density of chains that make only a part of it, or not in
/// proportion to it. Holds the scratch memory of one thread.
class PathWeight {
 public:
  virtual ~PathWeight() = default;
  /// Part of the light on a path that these chains make: in their density, and in their deposits.
  virtual double part(const Path& path, double log_light) = 0;
  /// Importance of light that lands there: in their density only.
  virtual float importance(const Vec2& raster) const = 0;
};

}  // namespace ajar
