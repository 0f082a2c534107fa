#include "scene/material/material.h"

#include "scene/material/bump.h"

namespace ajar {

Bsdf Material::bsdf(const SurfacePoint& at) const {
  Vec3 ns = at.ns;
  Vec3 tangent = at.dpdu;
  if (has_bump) {
    const BumpedFrame bumped = bump_frame(bump, at);
    ns = bumped.ns;
    tangent = bumped.dpdu;
  }
  Bsdf result(needs_tangent ? Frame::around(ns, tangent) : Frame::around(ns), at.ng);
  add_lobes(at, Spectrum(1.F), result);
  return result;
}

}  // namespace ajar
