#pragma once
#include "core/vector.h"
#include "path/path.h"

namespace ajar {

/// What multiplies the light on paths in the density of chains that are not to make all of it, or
/// not in proportion to it. Holds the scratch memory of one thread.
class PathWeight {
 public:
  virtual ~PathWeight() = default;
  /// What of the light on a path these chains make: in their density, and in what they deposit.
  /// `log_light`: ln luminance(f).
  virtual double part(const Path& path, double log_light) = 0;
  /// How much light counts that lands there: in their density only.
  virtual float importance(const Vec2& raster) const = 0;
};

}  // namespace ajar
