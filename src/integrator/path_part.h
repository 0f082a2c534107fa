#pragma once
#include "core/vector.h"
#include "transport/path_sampler.h"

namespace ajar {

/// Part of each path that Markov chains make, where others make the rest.
class PathPart {
 public:
  PathPart() = default;
  virtual ~PathPart() = default;
  /// Factor of a contribution that lands on `raster` in the target of the chains.
  virtual float share(const Contribution& contribution, const Vec2& raster) const = 0;
  /// Factor for a technique's contribution, with its MIS weight and without its roulette weight:
  /// its luminance.
  virtual float share(Technique technique, float light, const Vec2& raster) const = 0;
  /// Factor of the indirect light that they deposit there.
  virtual float kept(const Vec2& raster) const = 0;

 protected:
  PathPart(const PathPart&) = default;
  PathPart& operator=(const PathPart&) = default;
};

}  // namespace ajar
