#pragma once
#include "core/vector.h"
#include "transport/path_sampler.h"

namespace ajar {

/// Weight of Markov chains in the light of each path, where others make the rest.
class ChainWeight {
 public:
  ChainWeight() = default;
  virtual ~ChainWeight() = default;
  /// Factor of a contribution that lands on `raster` in the target of the chains.
  virtual float weight(const Contribution& contribution, const Vec2& raster) const = 0;
  /// Factor for a technique's contribution, with its MIS weight and without its roulette weight:
  /// its luminance.
  virtual float weight(Technique technique, float light, const Vec2& raster) const = 0;
  /// Factor of the indirect light that they deposit there.
  virtual float deposit_scale(const Vec2& raster) const = 0;

 protected:
  ChainWeight(const ChainWeight&) = default;
  ChainWeight& operator=(const ChainWeight&) = default;
};

}  // namespace ajar
