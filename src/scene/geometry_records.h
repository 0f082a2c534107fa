#pragma once
#include <embree3/rtcore.h>

#include <memory>
#include <optional>

#include "scene/ray.h"
#include "scene/shape/curve_shape.h"
#include "scene/shape/quadric.h"
#include "scene/shape/triangle_mesh.h"
#include "scene/texture/texture.h"

/// Implementation of `Geometry`: shared by its building, its queries and Embree's callbacks.
namespace ajar {

/// One shape in its final place; exactly one of mesh, curve and quadric is set unless it was
/// dropped.
struct ShapeRecord {
  std::unique_ptr<const TriangleMesh> mesh;
  std::unique_ptr<const CurveShape> curve;
  std::optional<Quadric> quadric;
  std::optional<Placement> placement;
  TextureSlot alpha{Spectrum(1.F)};
  TextureSlot shadow_alpha{Spectrum(1.F)};
  bool alpha_counted = false;  ///< reports hits where it is 0 instead of leaving them out
  bool reversed = false;
  bool derivatives = true;  ///< compute derivatives of hits
  /// Hits of the triangles at the ends of a ray must be distinguished from real ones.
  bool check_plane = false;

  bool present() const { return mesh || curve || quadric; }
  /// True if rays pass where alpha is 0.
  bool has_alpha() const { return !alpha.is_constant() && !alpha_counted; }
  bool has_counted_alpha() const { return !alpha.is_constant() && alpha_counted; }
  bool has_shadow_alpha() const { return !shadow_alpha.is_constant() || shadow_alpha.is_black(); }
};

struct InstanceRecord {
  std::optional<Placement> placement;  ///< empty: dropped
  std::size_t object = 0;
};

/// Embree's context with additional data for callbacks. The first member must stay first: Embree
/// hands back its address.
struct QueryContext {
  RTCIntersectContext embree;
  const Ray* ray;
  const InstanceRecord* instances;
  unsigned first_instance;  ///< Embree's id of instance 0
};

/// A ray in the space of a shape or of an instanced object, double precision.
struct LocalRay {
  Vec3d origin;
  Vec3d direction;
};
/// In the space in which an instanced object is defined; the world's if `instance` is null.
inline LocalRay to_instance(const Ray& ray, const Placement* instance) {
  const Vec3d o(ray.origin);
  const Vec3d d(ray.direction);
  if (instance == nullptr) return {o, d};
  return {instance->point_to_object(o), instance->vector_to_object(d)};
}
inline LocalRay to_shape(const LocalRay& ray, const Placement& shape) {
  return {shape.point_to_object(ray.origin), shape.vector_to_object(ray.direction)};
}
/// (b1, b2) where a ray, in the space of the object, meets a triangle. Embree has those of the
/// corner where products of two lengths are below 1e-18, which those of tiny triangles are.
inline Vec2 barycentric_of(const TriangleMesh& mesh, const RTCHit& hit, const Ray& world,
                           const Placement* instance) {
  const LocalRay ray = to_instance(world, instance);
  const Vec3d n(hit.Ng_x, hit.Ng_y, hit.Ng_z);
  constexpr double kSmall = 1e-16;
  if (std::abs(n.dot(ray.direction)) > kSmall) return {hit.u, hit.v};
  const double t = mesh.plane_distance(hit.primID, ray.origin, ray.direction);
  const Vec2 b = mesh.barycentric(hit.primID, ray.origin + ray.direction * t);
  return std::isfinite(b.x) && std::isfinite(b.y) ? b : Vec2(hit.u, hit.v);
}

/// Transforms a point of an instanced object into the world, with its derivatives or without; `p`
/// is its place there before it was rounded, which may be by much of what is left in the world.
void place_point(const Placement& instance, const Vec3d& p, bool derivatives, SurfacePoint& point);

/// Box of a quadric in its final place.
void placed_bounds(const Quadric& quadric, const Placement& placement, Vec3d& low, Vec3d& high);

/// Registers filters or user callbacks with Embree as far as the shape needs them. The record must
/// stay where it is.
void set_callbacks(RTCGeometry geometry, ShapeRecord& record);

}  // namespace ajar
