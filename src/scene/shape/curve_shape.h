#pragma once
#include <array>
#include <optional>
#include <vector>

#include "core/error.h"
#include "scene/desc/shape_data.h"
#include "scene/shape/placement.h"
#include "scene/surface_derivatives.h"
#include "scene/surface_point.h"

namespace ajar {

/// Cubic Bézier curves with widths, in their final place, as Embree wants them.
class CurveShape {
 public:
  enum class Type { Flat, Cylinder, Ribbon };
  /// Raises SceneError for counts that do not fit and points too far out. Widths are scaled
  /// by the mean scale of the transform.
  CurveShape(Type type, const desc::Curves& curves, const Placement& placement, bool reversed,
             const SourceLocation& where);

  Type type() const { return type_; }
  std::size_t segment_count() const { return first_vertex_.size(); }
  std::size_t vertex_count() const { return vertices_.size(); }
  /// x, y, z, radius.
  const std::array<float, 4>* vertices() const { return vertices_.data(); }
  const unsigned* first_vertices() const { return first_vertex_.data(); }
  /// Ribbons only: one per vertex; one more may be read.
  const Vec3* normals() const { return normals_.data(); }

  /// Where a ray meets a segment at curve parameter `u` and distance `t`; `ng` is Embree's normal.
  /// u runs along the segment, v across it from 0 to 1. Flat curves face the ray.
  SurfacePoint surface_point(std::uint32_t segment, float u, const Vec3& origin,
                             const Vec3& direction, float t, const Vec3& ng) const;
  /// Around a point `p` of a round curve, by the curve's own parameter and the angle around it;
  /// empty for others, and where the curve has no direction.
  std::optional<SurfaceDerivatives> derivatives(std::uint32_t segment, double u,
                                                const Vec3d& p) const;
  /// Hits nearer than this are the curve itself: where a ray leaves a curve, that curve is not a
  /// surface with two sides, but turns with the ray (flat) or is met with Newton's tolerance
  /// (others).
  float self_distance(std::uint32_t segment, float u) const;

 private:
  struct Sample {
    Vec3d center, tangent;
    double radius;
  };
  Sample sample(std::uint32_t segment, double u) const;

  Type type_;
  bool reversed_;
  std::vector<std::array<float, 4>> vertices_;
  std::vector<unsigned> first_vertex_;
  std::vector<Vec3> normals_;
};

}  // namespace ajar
