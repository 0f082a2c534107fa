#include "scene/material/bump.h"

namespace ajar {
namespace {
/// Step of the finite differences in u and v: pbrt-v3's choice where it knows no pixel footprint.
constexpr float kStep = 5e-4F;
/// A bump that tilts the normal closer than this (cosine) to the surface is ignored.
constexpr float kGrazingBump = 1e-4F;

SurfacePoint shifted(const SurfacePoint& at, const Vec3& dp, const Vec2& duv) {
  SurfacePoint moved = at;
  moved.p += dp * kStep;
  moved.uv += duv * kStep;
  return moved;
}
}  // namespace

BumpedFrame bump_frame(const TextureSlot& displacement, const SurfacePoint& at) {
  const float here = displacement.eval_float(at);
  const float along_u = displacement.eval_float(shifted(at, at.dpdu, Vec2(1.F, 0.F)));
  const float along_v = displacement.eval_float(shifted(at, at.dpdv, Vec2(0.F, 1.F)));
  const Vec3 dpdu = at.dpdu + at.ns * ((along_u - here) / kStep) + at.dndu * here;
  const Vec3 dpdv = at.dpdv + at.ns * ((along_v - here) / kStep) + at.dndv * here;
  const Vec3 n = cross(dpdu, dpdv);
  const float squared = length_squared(n);
  if (!(squared > 0.F) || !std::isfinite(squared)) return {at.ns, at.dpdu};
  const Vec3 ns = face_forward(n / std::sqrt(squared), at.ng);
  if (!(abs_dot(ns, at.ng) >= kGrazingBump)) return {at.ns, at.dpdu};
  return {ns, dpdu};
}

}  // namespace ajar
