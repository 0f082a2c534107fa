#pragma once
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/error.h"
#include "core/warnings.h"
#include "scene/coordinate_limit.h"
#include "scene/desc/scene_desc.h"
#include "scene/hit.h"
#include "scene/ray.h"
#include "scene/ray_log.h"
#include "scene/scene_counts.h"
#include "scene/shape/surface_sampler.h"
#include "scene/surface_point.h"
#include "scene/texture/texture.h"

struct RTCDeviceTy;
struct RTCSceneTy;

namespace ajar {

struct InstanceRecord;
struct QueryContext;
struct ShapeRecord;
struct SurfaceDerivatives;

/// Everything rays can hit, committed to Embree; knows shapes and alpha textures but neither
/// materials nor lights. Immutable, shared by all threads.
///
/// Shapes have a flat index: those of the description first, then those of object 0, object 1, …
class Geometry {
 public:
  /// Takes the shapes out of `description` (their other members stay); the textures must outlive
  /// this. Raises SceneError for meshes that cannot be used, and for shapes and instances that are
  /// too large or too far away to be traced; shapes that cannot be seen are dropped with a warning.
  Geometry(desc::SceneDesc& description, const TextureList& textures, Warnings& warnings);
  ~Geometry();
  Geometry(const Geometry&) = delete;
  Geometry& operator=(const Geometry&) = delete;

  /// Nearest surface along `ray`, alpha textures applied; false if there is none, or if the ray
  /// cannot be traced.
  bool intersect(const Ray& ray, GeometryHit& hit) const;
  /// True if anything lies on `ray`, alpha and shadow alpha textures applied, or if the ray cannot
  /// be traced.
  bool occluded(const Ray& ray) const;
  /// Derivatives of the surface at a hit; empty where it is not smooth: on curves that face the
  /// ray, ribbons, and triangles without area. Triangles are smooth inside.
  std::optional<SurfaceDerivatives> derivatives(const GeometryHit& hit) const;
  /// False if coordinates of `ray` are not numbers or so large that Embree must not be given them,
  /// in the world or in the space of an instance. Everything that Embree traces was asked here.
  bool can_trace(const Ray& ray) const {
    // All at once, without branches; the direction is a unit vector if it is one at all.
    const auto within = [](const Vec3& v, float limit) {
      return static_cast<int>(std::abs(v.x) <= limit) & static_cast<int>(std::abs(v.y) <= limit) &
             static_cast<int>(std::abs(v.z) <= limit);
    };
    return (within(ray.origin, max_ray_coordinate_) & within(ray.direction, 2.F) &
            static_cast<int>(!std::isnan(ray.t_max))) != 0;
  }
  /// Raises SceneError, located at the instance, if there is one into whose space rays cannot be
  /// transformed that start at coordinates of `reach`.
  void require_reach(double reach, const desc::SceneDesc& description) const;

  /// From now on every ray is written to `log`, until it is null again. For benchmarks: one thread
  /// only.
  void log_rays(RayLog* log) { ray_log_ = log; }
  /// Traces the rays of a log again and ignores their hits.
  void replay(const RayLog& log) const;

  /// From now on hits of this shape have no derivatives.
  void leave_out_derivatives(std::size_t shape);

  /// Flat index of the first shape of an object.
  std::size_t object_base(std::size_t object) const { return object_base_[object]; }
  std::size_t shape_count() const;
  /// False if the shape was dropped (or belongs to an object that nothing places).
  bool has_shape(std::size_t shape) const;
  /// True if there is a place for the hit: its shape, the instance that has it, and its primitive.
  bool has_place_of(const GeometryHit& hit) const;
  /// Null if the shape cannot emit: it has no area, was dropped, or is a curve.
  std::unique_ptr<SurfaceSampler> make_sampler(std::size_t shape) const;

  /// Empty box if there is nothing.
  const Box3& bounds() const { return bounds_; }
  /// Box around everything that emits nothing. Empty if there is nothing.
  const Box3& receivers() const { return receivers_; }
  /// The geometric part of the counts.
  const SceneCounts& counts() const { return counts_; }

 private:
  struct Release {
    void operator()(RTCDeviceTy* device) const;
    void operator()(RTCSceneTy* scene) const;
  };
  using SceneHandle = std::unique_ptr<RTCSceneTy, Release>;

  QueryContext make_context(const Ray& ray) const;
  void prepare_shapes(desc::SceneDesc& description, const TextureList& textures,
                      Warnings& warnings);
  void prepare_instances(const desc::SceneDesc& description, Warnings& warnings);
  SceneHandle commit(std::size_t first, std::size_t count, bool with_instances) const;
  /// Boxes in the world, empty for dropped instances.
  std::vector<Box3> instance_boxes() const;
  void check_instances(const desc::SceneDesc& description, const std::vector<Box3>& boxes);
  void find_receivers(const desc::SceneDesc& description, const std::vector<Box3>& instances);
  void count(std::size_t object_count);

  SourceLocation where_;  ///< the scene's file, for errors that no shape is to blame for
  /// Outlives the device, whose memory it counts.
  std::unique_ptr<std::atomic<std::int64_t>> embree_bytes_;
  std::vector<ShapeRecord> shapes_;
  std::vector<InstanceRecord> instances_;
  std::vector<std::size_t> object_base_;  ///< one more than there are objects
  std::unique_ptr<RTCDeviceTy, Release> device_;
  std::vector<SceneHandle> objects_;
  SceneHandle top_;
  Box3 bounds_;
  Box3 receivers_;
  float max_ray_coordinate_ = kMaxRayCoordinate;  ///< less if an instance makes rays longer
  SceneCounts counts_;
  RayLog* ray_log_ = nullptr;
};

}  // namespace ajar
