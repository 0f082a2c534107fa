#include "scene/material/material.h"

#include <memory>
namespace ajar {

void Material::bsdf(const SurfacePoint& at, Bsdf& result) const {
  Vec3 ns = at.ns;
  Vec3 tangent = at.dpdu;
  if (!relief.is_flat()) {
    const ReliefFrame tilted = relief.frame(at);
    ns = tilted.ns;
    tangent = tilted.dpdu;
  }
  // In place: most of a Bsdf is room for lobes that few materials use.
  std::construct_at(&result, needs_tangent ? Frame::around(ns, tangent) : Frame::around(ns), at.ng);
  add_lobes(at, Spectrum(1.F), result);
}

}  // namespace ajar
