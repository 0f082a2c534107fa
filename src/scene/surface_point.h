#pragma once
#include <cstdint>

#include "core/vector.h"

namespace ajar {

/// A point on a surface with everything that textures and materials need. World space. The
/// derivatives are left zero where nobody asked for them: only bumps and anisotropic materials do.
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

/// `p` moved off the surface with geometric normal `ng` to the side that `w` points to, by as
/// little as float rounding of `p` demands: neither leaks nor self-shadows. Source: Wächter &
/// Binder 2019, "A fast and robust method for avoiding self-intersection".
inline Vec3 offset_ray_origin(const Vec3& p, const Vec3& ng, const Vec3& w) {
  // Half an ulp, relative: the error of rounding one coordinate.
  constexpr float kHalfUlp = 0x1p-24F;
  // Points are rounded once when found and once more after the offset, and Embree's plane test errs
  // by a few roundings of the size of a triangle; 16 covers all of that while it stays near 10⁻⁶ of
  // the coordinates.
  constexpr float kSafety = 16.F;
  // Near the origin rounding vanishes but the intersection's error does not: it scales with the
  // triangle.
  constexpr float kAtOrigin = 0x1p-20F;
  // Wächter & Binder step each coordinate by its own ulps, which is too little along slanted
  // normals when one coordinate is large. The distance along the normal by which rounding can
  // displace p is Σ |n_i| · ½ulp(p_i); going a multiple of that along the normal keeps their
  // locality and is enough for every direction.
  const float rounding = std::abs(ng.x * p.x) + std::abs(ng.y * p.y) + std::abs(ng.z * p.z);
  const float distance = kSafety * kHalfUlp * rounding + kAtOrigin;
  return p + ng * (dot(ng, w) < 0.F ? -distance : distance);
}

}  // namespace ajar
