#pragma once
#include <ImathBox.h>
#include <ImathMatrix.h>
#include <ImathVec.h>

#include <cmath>

/// Vectors and matrices are Imath's. Imath multiplies row vectors from the left (p' = p * M), so
/// "first A, then B" is `A * B`. Transforms are kept in double precision, geometry in single.
namespace ajar {

using Vec2 = Imath::V2f;
using Vec2i = Imath::V2i;
using Vec3 = Imath::V3f;
using Vec3d = Imath::V3d;
using Mat4 = Imath::M44d;
using Box3 = Imath::Box3f;
using Box2i = Imath::Box2i;

inline constexpr float kPi = 3.14159265358979323846F;
inline constexpr float kInvPi = 0.31830988618379067154F;
/// Largest float below one: uniform numbers live in [0, 1).
inline constexpr float kOneMinusEpsilon = 0x1.fffffep-1F;

inline float dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline float abs_dot(const Vec3& a, const Vec3& b) { return std::abs(dot(a, b)); }
inline Vec3 cross(const Vec3& a, const Vec3& b) { return a.cross(b); }
inline float length_squared(const Vec3& v) { return dot(v, v); }
inline float length(const Vec3& v) { return std::sqrt(dot(v, v)); }
inline Vec3 normalize(const Vec3& v) { return v / length(v); }
inline bool is_finite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
/// `v`, turned so that it lies in the hemisphere around `reference`.
inline Vec3 face_forward(const Vec3& v, const Vec3& reference) {
  return dot(v, reference) < 0.F ? -v : v;
}

/// Image of a point, a direction, and a surface normal under `m` (the normal needs the inverse).
inline Vec3 transform_point(const Mat4& m, const Vec3& p) {
  Vec3d result;
  m.multVecMatrix(Vec3d(p), result);
  return Vec3(result);
}
inline Vec3 transform_vector(const Mat4& m, const Vec3& v) {
  Vec3d result;
  m.multDirMatrix(Vec3d(v), result);
  return Vec3(result);
}
inline Vec3 transform_normal(const Mat4& inverse, const Vec3& n) {
  Vec3d result;
  inverse.transposed().multDirMatrix(Vec3d(n), result);
  return Vec3(result);
}
/// True if the transform turns a right-handed frame into a left-handed one.
inline bool swaps_handedness(const Mat4& m) {
  const Vec3d x(m[0][0], m[0][1], m[0][2]);
  const Vec3d y(m[1][0], m[1][1], m[1][2]);
  const Vec3d z(m[2][0], m[2][1], m[2][2]);
  return x.cross(y).dot(z) < 0.0;
}

}  // namespace ajar
