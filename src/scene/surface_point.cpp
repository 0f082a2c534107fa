#include "scene/surface_point.h"

namespace ajar {

namespace {
/// Half an ulp, relative: the error of rounding one coordinate.
constexpr float kHalfUlp = 0x1p-24F;
/// Points are rounded once when found and once more after the offset, and Embree's plane test errs
/// by a few roundings of the size of a triangle; 16 covers all of that while it stays near 10⁻⁶ of
/// the coordinates.
constexpr float kSafety = 16.F;
/// Near the origin rounding vanishes but the intersection's error does not: it scales with the
/// triangle.
constexpr float kAtOrigin = 0x1p-20F;
}  // namespace

Vec3 offset_ray_origin(const Vec3& p, const Vec3& ng, const Vec3& w) {
  // Wächter & Binder step each coordinate by its own ulps, which is too little along slanted
  // normals when one coordinate is large. The distance along the normal by which rounding can
  // displace p is Σ |n_i| · ½ulp(p_i); going a multiple of that along the normal keeps their
  // locality and is enough for every direction.
  const float rounding = std::abs(ng.x * p.x) + std::abs(ng.y * p.y) + std::abs(ng.z * p.z);
  const float distance = kSafety * kHalfUlp * rounding + kAtOrigin;
  return p + ng * (dot(ng, w) < 0.F ? -distance : distance);
}

}  // namespace ajar
