#pragma once
#include <span>

#include "core/distribution.h"
#include "scene/light/light.h"

namespace ajar {

struct ChosenLight {
  const Light* light;  ///< never null
  Pdf<Discrete> probability;
  float u;  ///< the uniform number, stretched to [0, 1) again
};

/// Chooses among the lights of a scene. The choice may depend on the point to be lit, the
/// probability of a choice is the same from whichever end of a path it is asked. Every light whose
/// power is not zero can be chosen; if all are zero, all are equally likely. Today both choices are
/// by power alone.
class LightSampler {
 public:
  /// `lights` must outlive it, and the `index` of each must be its position.
  explicit LightSampler(std::span<const std::unique_ptr<Light>> lights);
  bool empty() const;
  /// For next event estimation at `reference`; requires !empty().
  ChosenLight choose(const Vec3& reference, float u) const;
  Pdf<Discrete> probability(const Vec3& reference, const Light& light) const;
  /// For the start of a light subpath; requires !empty().
  ChosenLight choose_emitter(float u) const;
  Pdf<Discrete> emitter_probability(const Light& light) const;

 private:
  std::span<const std::unique_ptr<Light>> lights_;
  Distribution1D by_power_;
};

}  // namespace ajar
