#pragma once
#include <cmath>

#include "core/vector.h"

namespace ajar::testing {

inline Mat4 translation(double x, double y, double z) {
  Mat4 m;
  m.setTranslation(Vec3d(x, y, z));
  return m;
}
inline Mat4 translation(const Vec3& offset) {
  return translation(double{offset.x}, double{offset.y}, double{offset.z});
}
inline Mat4 scaling(double x, double y, double z) {
  Mat4 m;
  m.setScale(Vec3d(x, y, z));
  return m;
}
inline Mat4 rotation(const Vec3& axis, double radians) {
  Mat4 m;
  m.setAxisAngle(Vec3d(axis).normalized(), radians);
  return m;
}
/// Left-handed, as pbrt's LookAt: at `from`, +z toward `to`, +y up.
inline Mat4 aimed(const Vec3& from, const Vec3& to) {
  const Vec3d z = Vec3d(to - from).normalized();
  const Vec3d up = std::abs(z.y) < 0.99 ? Vec3d(0, 1, 0) : Vec3d(1, 0, 0);
  const Vec3d x = up.cross(z).normalized();
  const Vec3d y = z.cross(x);
  return Mat4(x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, from.x, from.y, from.z, 1);
}

}  // namespace ajar::testing
