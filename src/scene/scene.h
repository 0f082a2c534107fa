#pragma once
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/spectrum.h"
#include "core/warnings.h"
#include "scene/camera/camera.h"
#include "scene/desc/scene_desc.h"
#include "scene/hit.h"
#include "scene/light/light.h"
#include "scene/light/light_sampler.h"
#include "scene/material/material.h"
#include "scene/medium/medium.h"
#include "scene/ray.h"
#include "scene/ray_log.h"
#include "scene/scene_counts.h"
#include "scene/surface_point.h"

namespace ajar {

class Geometry;
struct SurfaceDerivatives;

/// Settings that change how a scene is built.
struct BuildOptions {
  std::optional<Vec2i> resolution;  ///< resolution of the full image, instead of the file's
};

/// An immutable scene, committed to Embree and shared by all threads. Nothing random in it.
class Scene {
 public:
  /// Takes the description (geometry is moved or shared, not copied, where possible). Raises
  /// SceneError if the scene cannot be used (for example indices out of range); lesser faults
  /// become warnings.
  Scene(desc::SceneDesc&& description, const BuildOptions& options, Warnings& warnings);
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// Nearest surface along `ray`, alpha textures applied; empty, too, if the ray cannot be traced.
  /// Interface materials are reported like any other.
  std::optional<Hit> intersect(const Ray& ray) const;
  /// Writes into `hit`, which is undefined if this returns false.
  bool intersect(const Ray& ray, Hit& hit) const;
  /// An earlier hit, with the data of its shape; empty if there is no such shape.
  std::optional<Hit> recall(const GeometryHit& hit) const;
  /// Derivatives of the surface and of its shading normal before bumps and normal maps
  /// (scene/surface_derivatives.h); empty where they are unknown: see Geometry.
  std::optional<SurfaceDerivatives> derivatives(const Hit& hit) const;
  /// True if anything at all lies between (interfaces too; see `transmittance` of transport for
  /// those), or if the ray cannot be traced.
  bool occluded(const Ray& ray) const;
  /// False if coordinates of `ray` are not numbers, or too large. The scene itself has none that
  /// are; but light that scatters in a thin medium may go anywhere.
  bool can_trace(const Ray& ray) const;
  /// See Geometry. Not for renders.
  void log_rays(RayLog* log);
  void replay(const RayLog& log) const;
  /// True if some material is an interface, or some cut-out is a hit: then `occluded` alone does
  /// not decide about visibility.
  bool has_interfaces() const { return has_interfaces_; }
  /// True if light passes some surface straight on without adding to the depth of its path.
  bool has_uncounted() const { return has_uncounted_; }
  /// True if some interface adds to the depth of paths that cross it.
  bool has_counted_interfaces() const { return has_counted_interfaces_; }
  /// True if the camera looks past lights at the background.
  bool hides_lights() const { return hides_lights_; }

  const Camera& camera() const { return *camera_; }
  const LightSampler& light_sampler() const { return *light_sampler_; }
  std::span<const std::unique_ptr<Light>> lights() const { return lights_; }
  /// The lights that rays leaving the scene run into.
  std::span<const Light* const> infinite_lights() const { return infinite_lights_; }
  const Medium* medium(desc::MediumId id) const {
    return id < 0 ? nullptr : media_[static_cast<std::size_t>(id)].get();
  }
  std::span<const std::unique_ptr<const Medium>> media() const { return media_; }
  const Material& material(desc::MaterialId id) const {
    return *materials_[static_cast<std::size_t>(id)];
  }

  /// By `Hit::object_id` and `Hit::material_id`. Unnamed ones are called shape-N or material-N, N
  /// the number in the layers "object-id" and "material-id" (from 1).
  std::span<const std::string> object_names() const { return object_names_; }
  std::span<const std::string> material_names() const { return material_names_; }

  const Box3& bounds() const { return bounds_; }
  const BoundingSphere& bounding_sphere() const { return bounding_sphere_; }
  const SceneCounts& counts() const { return counts_; }
  /// Hash of the description it was built from.
  std::uint64_t hash() const { return hash_; }
  /// Film settings of the description, resolution as built.
  const desc::Film& film() const { return film_; }
  const std::string& source() const { return source_; }

 private:
  /// Surface data that a hit looks up by the index of its shape.
  struct Surface {
    const Material* material;
    const Light* light;
    const MediumInterface* media;
    std::uint32_t object_id;
    std::uint32_t material_id;
  };
  void build_lights(const desc::SceneDesc& description, Warnings& warnings);
  double reach_of_rays() const;
  /// Fills in the data of the shape.
  void complete(Hit& hit) const;
  void build_surfaces(const desc::SceneDesc& description, Warnings& warnings);
  void name_things(const desc::SceneDesc& description);

  TextureList textures_;
  std::unique_ptr<Geometry> geometry_;
  std::vector<Surface> surfaces_;
  std::vector<std::unique_ptr<const MediumInterface>> media_interfaces_;
  std::vector<std::unique_ptr<const SurfaceSampler>> emitters_;
  MaterialList materials_;
  std::vector<std::string> object_names_;
  std::vector<std::string> material_names_;
  std::vector<std::unique_ptr<const Medium>> media_;
  LightList lights_;
  std::vector<const Light*> infinite_lights_;
  std::unique_ptr<LightSampler> light_sampler_;
  std::unique_ptr<Camera> camera_;
  Box3 bounds_;
  BoundingSphere bounding_sphere_;
  SceneCounts counts_;
  std::uint64_t hash_ = 0;
  desc::Film film_;
  std::string source_;
  bool has_interfaces_ = false;
  bool has_uncounted_ = false;
  bool has_counted_interfaces_ = false;
  bool hides_lights_ = false;
};

}  // namespace ajar
