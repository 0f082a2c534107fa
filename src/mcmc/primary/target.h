#pragma once
#include "mcmc/primary/step_kind.h"
#include "mcmc/splat.h"
#include "transport/sample_source.h"

namespace ajar {

/// Target function of a chain: a function of the primary vector. Used by one thread.
class Target {
 public:
  virtual ~Target() = default;
  /// The contribution function I ≥ 0 of the state `numbers`; appends its splats. It must be a
  /// function of `numbers` alone. `change` names the streams that may differ from the state that
  /// was last accepted: results of the others alone may be reused, without requesting their
  /// numbers. In a step of the raster numbers alone it may replace numbers, so that something else
  /// stays (`SampleSource::replace_pair`). A state that is placed on the image by the raster
  /// numbers, the first pair of the camera's vertex 0, asks for them in every case, and before
  /// others of that vertex.
  virtual double evaluate(SampleSource& numbers, const Change& change, SplatBuffer& splats) = 0;
  /// The state evaluated last is the current one from now on, or is forgotten. Exactly one of the
  /// two follows each `evaluate`.
  virtual void accepted() {}
  virtual void rejected() {}
};

}  // namespace ajar
