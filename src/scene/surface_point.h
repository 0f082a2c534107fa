#pragma once
#include <cmath>
#include <cstdint>

#include "core/vector.h"

namespace ajar {

/// A point on a surface with everything that textures and materials need. World space. Derivatives
/// are zero unless requested: only bumps and anisotropic materials need them.
struct SurfacePoint {
  Vec3 p;
  Vec3 ng;  ///< unit geometric normal; its side is that of the shape's orientation, not of the ray
  Vec3 ns;  ///< unit shading normal, in the hemisphere of `ng`
  Vec2 uv;
  Vec3 dpdu;  ///< not normalised; never zero where asked for
  Vec3 dpdv;
  /// Derivatives of the shading normal, for bump mapping; zero for flat shading.
  Vec3 dndu;
  Vec3 dndv;
  std::uint32_t primitive = 0;  ///< triangle within its mesh; 0 for other shapes
};

/// Half an ulp, relative: the error of rounding one number.
inline constexpr float kHalfUlp = 0x1p-24F;

/// Roundings of the coordinates of a point by which the origins of rays are moved off a surface.
/// Two are needed: the point is rounded once when it is found and once more when it is moved. The
/// rest is for errors of the tests for triangles (`TriangleMesh::plane_error`).
inline constexpr float kOffsetRoundings = 4.F;

/// Distance along the unit normal `ng` by which rounding the coordinates of `p` can displace it.
inline float rounding_along(const Vec3& p, const Vec3& ng) {
  return kHalfUlp * (std::abs(ng.x * p.x) + std::abs(ng.y * p.y) + std::abs(ng.z * p.z));
}

/// `p` moved off the surface with geometric normal `ng` to the side that `w` points to, by as
/// little as float rounding of `p` demands: neither leaks nor self-shadows. There is no length in
/// it, so scenes of any size are alike. Source: Wächter & Binder 2019, "A fast and robust method
/// for avoiding self-intersection".
inline Vec3 offset_ray_origin(const Vec3& p, const Vec3& ng, const Vec3& w) {
  // Wächter & Binder step each coordinate by its own ulps, which is too little along slanted
  // normals when one coordinate is large. A multiple of the rounding along the normal keeps their
  // locality and is enough for every direction.
  const float distance = kOffsetRoundings * rounding_along(p, ng);
  return p + ng * (dot(ng, w) < 0.F ? -distance : distance);
}

/// Offset end at `p` of a ray that comes from `distance` away; `w` points back to where it comes
/// from. Directions are rounded, and Embree's tests err, by some roundings of that distance.
inline Vec3 offset_ray_end(const Vec3& p, const Vec3& ng, const Vec3& w, float distance) {
  constexpr float kRoundings = 16.F;
  const float moved = kOffsetRoundings * rounding_along(p, ng) + kRoundings * kHalfUlp * distance;
  return p + ng * (dot(ng, w) < 0.F ? -moved : moved);
}

}  // namespace ajar
