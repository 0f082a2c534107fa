#pragma once
#include <optional>

#include "core/vector.h"

namespace ajar {

/// An invertible transform of a shape and derived quantities, in double precision.
class Placement {
 public:
  /// Empty if `to_world` is singular or not finite.
  static std::optional<Placement> make(const Mat4& to_world);

  Vec3d point(const Vec3d& p) const;
  Vec3d vector(const Vec3d& v) const;
  /// Not normalised; keeps outward normals outward even if the transform mirrors.
  Vec3d normal(const Vec3d& n) const;
  Vec3d point_to_object(const Vec3d& p) const;
  Vec3d vector_to_object(const Vec3d& v) const;
  /// Area in the world of a unit of area with unit normal `n` in object space.
  double area_stretch(const Vec3d& n) const { return abs_determinant_ * normal(n).length(); }
  /// The factor by which a similarity scales lengths; empty for any other transform.
  std::optional<double> similarity_scale() const;
  /// Geometric mean of the factors by which lengths are scaled.
  double mean_scale() const { return std::cbrt(abs_determinant_); }
  bool mirrors() const { return mirrors_; }
  bool is_identity() const { return to_world_ == Mat4(); }
  const Mat4& to_world() const { return to_world_; }
  const Mat4& to_object() const { return to_object_; }

 private:
  Mat4 to_world_;
  Mat4 to_object_;
  double abs_determinant_ = 1.0;
  bool mirrors_ = false;
};

}  // namespace ajar
