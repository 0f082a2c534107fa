#include "scene/shape/placement.h"

#include <algorithm>

namespace ajar {

namespace {
Vec3d row(const Mat4& m, int i) { return {m[i][0], m[i][1], m[i][2]}; }
}  // namespace

std::optional<Placement> Placement::make(const Mat4& to_world) {
  const Vec3d x = row(to_world, 0);
  const Vec3d y = row(to_world, 1);
  const Vec3d z = row(to_world, 2);
  const double determinant = x.cross(y).dot(z);
  const double volume = x.length() * y.length() * z.length();
  // Compared with the box of its axes, so that a uniformly tiny scale is not mistaken for a
  // singular one.
  if (!std::isfinite(volume) || !(std::abs(determinant) > 1e-12 * volume)) return std::nullopt;
  Placement placement;
  placement.to_world_ = to_world;
  // Adjugate over determinant: Imath's own inverse treats small determinants as singular.
  const Vec3d columns[3] = {y.cross(z) / determinant, z.cross(x) / determinant,
                            x.cross(y) / determinant};
  const Vec3d t = row(to_world, 3);
  Mat4& inverse = placement.to_object_;
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) inverse[i][j] = columns[j][i];
    inverse[3][j] = -t.dot(columns[j]);
    if (!std::isfinite(columns[j].length()) || !std::isfinite(inverse[3][j])) return std::nullopt;
  }
  placement.abs_determinant_ = std::abs(determinant);
  placement.mirrors_ = determinant < 0.0;
  return placement;
}

Vec3d Placement::point(const Vec3d& p) const {
  return row(to_world_, 0) * p.x + row(to_world_, 1) * p.y + row(to_world_, 2) * p.z +
         row(to_world_, 3);
}
Vec3d Placement::vector(const Vec3d& v) const {
  return row(to_world_, 0) * v.x + row(to_world_, 1) * v.y + row(to_world_, 2) * v.z;
}
Vec3d Placement::normal(const Vec3d& n) const {
  return {row(to_object_, 0).dot(n), row(to_object_, 1).dot(n), row(to_object_, 2).dot(n)};
}
Vec3d Placement::point_to_object(const Vec3d& p) const {
  return row(to_object_, 0) * p.x + row(to_object_, 1) * p.y + row(to_object_, 2) * p.z +
         row(to_object_, 3);
}
Vec3d Placement::vector_to_object(const Vec3d& v) const {
  return row(to_object_, 0) * v.x + row(to_object_, 1) * v.y + row(to_object_, 2) * v.z;
}

std::optional<double> Placement::similarity_scale() const {
  const Vec3d x = row(to_world_, 0);
  const Vec3d y = row(to_world_, 1);
  const Vec3d z = row(to_world_, 2);
  const double squared = x.dot(x);
  const double worst = std::max({std::abs(y.dot(y) - squared), std::abs(z.dot(z) - squared),
                                 std::abs(x.dot(y)), std::abs(y.dot(z)), std::abs(z.dot(x))});
  // Transforms in files are written with about six digits.
  if (worst > 1e-5 * squared) return std::nullopt;
  return std::sqrt(squared);
}

}  // namespace ajar
