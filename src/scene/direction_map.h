#pragma once
#include <algorithm>
#include <cmath>

#include "core/vector.h"

namespace ajar {

/// Maps directions between the space of a light or camera and the world, with the change of solid
/// angle. Scenes do scale and mirror such spaces, so nothing is assumed but that the map can be
/// inverted.
class DirectionMap {
 public:
  struct Local {
    Vec3 w;         ///< unit
    float stretch;  ///< dω_local / dω_world: factor of a local density in the world
  };

  /// Identity.
  DirectionMap() = default;
  /// Only the linear part of `to_world` counts; requires invertible(to_world).
  explicit DirectionMap(const Mat4& to_world)
      : to_world_(linear_part(to_world)),
        to_local_(linear_part(to_world.inverse())),
        local_volume_(static_cast<float>(std::abs(1.0 / determinant(to_world)))) {}

  /// True if the linear part of `m` is finite and far enough from singular to compute with, and
  /// neither stretches nor shrinks vectors by so much that third powers leave the range of floats.
  static bool invertible(const Mat4& m) {
    constexpr double kMaxStretch = 1e12;
    const auto within = [](const Mat4& a) {
      const auto row = [&](int i) { return Vec3d(a[i][0], a[i][1], a[i][2]).length(); };
      return std::max({row(0), row(1), row(2)}) <= kMaxStretch ? row(0) * row(1) * row(2) : 0.0;
    };
    const double size = within(m);
    return size > 0.0 && std::abs(determinant(m)) > 1e-12 * size && within(m.inverse()) > 0.0;
  }

  /// Images of vectors of any length; lengths are stretched.
  Vec3 vector_to_world(const Vec3& local) const { return local * to_world_; }
  Vec3 vector_to_local(const Vec3& world) const { return world * to_local_; }
  /// Unit image of a direction.
  Vec3 to_world(const Vec3& local) const { return normalize(vector_to_world(local)); }
  /// Maps a unit direction. A linear map with determinant D scales the solid angle at unit w by |D|
  /// / |image of w|³.
  Local to_local(const Vec3& w) const {
    const Vec3 v = vector_to_local(w);
    const float squared = length_squared(v);
    const float inverse_length = 1.F / std::sqrt(squared);
    return {v * inverse_length, local_volume_ * inverse_length / squared};
  }

 private:
  static double determinant(const Mat4& m) {
    const Vec3d x(m[0][0], m[0][1], m[0][2]);
    const Vec3d y(m[1][0], m[1][1], m[1][2]);
    const Vec3d z(m[2][0], m[2][1], m[2][2]);
    return x.cross(y).dot(z);
  }
  static Imath::M33f linear_part(const Mat4& m) {
    Imath::M33f result;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) result[i][j] = static_cast<float>(m[i][j]);
    }
    return result;
  }

  Imath::M33f to_world_;
  Imath::M33f to_local_;
  float local_volume_ = 1.F;  ///< |det to_local_|
};

}  // namespace ajar
