#include "scene/scene.h"

#include <algorithm>
#include <cmath>

#include "core/number_text.h"
#include "scene/build/validate.h"
#include "scene/coordinate_limit.h"
#include "scene/emission/emission.h"
#include "scene/geometry.h"
#include "scene/light/make_light.h"
#include "scene/seen_warnings.h"
#include "scene/surface_derivatives.h"

namespace ajar {

namespace {

constexpr WarningKind kInstanced{
    Effect::Light, "surfaces that are instanced cannot be lights: their emission is left out"};
constexpr WarningKind kTiny{Effect::Geometry,
                            "scenes are so small that triangles lose digits: scale them up"};
constexpr WarningKind kNoLight{Effect::Light, "scenes have no light"};
constexpr WarningKind kNoMaterial{
    Effect::Light, "surfaces without material cannot be lights: give them a black matte one"};
constexpr WarningKind kNoEmitter{Effect::Light,
                                 "curves, or surfaces without area, cannot be lights"};

BoundingSphere sphere_around(const Box3& box) {
  if (box.isEmpty()) return {};
  const Vec3d low(box.min);
  const Vec3d high(box.max);
  // Slightly larger, so that rays that start on it start outside of everything.
  const double radius = (high - low).length() * 0.5 * 1.0001;
  const auto rounded = static_cast<float>(radius);
  return {Vec3((low + high) * 0.5), rounded > 0.F ? rounded : 1.F};
}

std::vector<std::unique_ptr<const Medium>> build_media(const desc::SceneDesc& description) {
  std::vector<std::unique_ptr<const Medium>> media;
  for (const desc::Medium& m : description.media) {
    const Spectrum sigma_a(m.sigma_a.x, m.sigma_a.y, m.sigma_a.z);
    const Spectrum sigma_s(m.sigma_s.x, m.sigma_s.y, m.sigma_s.z);
    if (m.density && m.density->grid->is_colored()) {
      media.push_back(std::make_unique<const Medium>(
          m.name, m.g, std::make_unique<const ColorField>(*m.density, sigma_a, sigma_s)));
    } else {
      media.push_back(std::make_unique<const Medium>(
          m.name, sigma_a, sigma_s, m.g,
          m.density ? std::make_unique<const DensityField>(*m.density) : nullptr));
    }
  }
  return media;
}

}  // namespace

Scene::Scene(desc::SceneDesc&& given, const BuildOptions& options, Warnings& warnings)
    : hash_(desc::hash(given)), film_(given.film), source_(given.source) {
  desc::SceneDesc description = std::move(given);
  if (options.resolution) film_.resolution = *options.resolution;
  validate_references(description);
  counts_.materials = description.materials.size();
  add_default_material(description);

  textures_ = build_textures(description, warnings);
  materials_ = build_materials(description, textures_, warnings);
  media_ = build_media(description);
  geometry_ = std::make_unique<Geometry>(description, textures_, warnings);
  bounds_ = geometry_->bounds();
  bounding_sphere_ = sphere_around(bounds_);
  if (bounding_sphere_.radius < kMinRadius && geometry_->counts().triangles > 0) {
    warnings.add(kTiny, {std::make_shared<const std::string>(source_), 0, 0},
                 "the scene has a radius of " + number_text(double{bounding_sphere_.radius}) +
                     ": below " + number_text(double{kMinRadius}) +
                     " triangles lose digits; scale it up");
  }
  build_surfaces(description, warnings);
  name_things(description);
  build_lights(description, warnings);
  light_sampler_ = std::make_unique<LightSampler>(lights_, bounding_sphere_);
  camera_ = make_camera(description.camera, film_.resolution, bounding_sphere_.center,
                        bounding_sphere_.radius);
  camera_->medium = medium(description.camera.medium);
  hides_lights_ = description.camera.hides_lights;
  geometry_->require_reach(reach_of_rays(), description);

  SceneCounts counted = geometry_->counts();
  counted.materials = counts_.materials;
  counted.lights = lights_.size();
  counts_ = counted;
  add_seen_warnings(*this, description.camera, description.warnings_if_seen, warnings);
}

Scene::~Scene() = default;

void Scene::build_surfaces(const desc::SceneDesc& description, Warnings& warnings) {
  // Most shapes share one of very few interfaces.
  const auto shared_interface = [this](const MediumInterface& wanted) {
    const auto same = [&](const auto& known) {
      return known->inside == wanted.inside && known->outside == wanted.outside &&
             known->changes == wanted.changes;
    };
    const auto found = std::find_if(media_interfaces_.begin(), media_interfaces_.end(), same);
    if (found != media_interfaces_.end()) return found->get();
    media_interfaces_.push_back(std::make_unique<const MediumInterface>(wanted));
    return static_cast<const MediumInterface*>(media_interfaces_.back().get());
  };
  const auto add = [&](const desc::Shape& shape) {
    const MediumInterface media{medium(shape.inside), medium(shape.outside),
                                shape.has_medium_interface};
    const Material& material = *materials_[static_cast<std::size_t>(shape.material)];
    if (geometry_->has_shape(surfaces_.size())) {
      has_interfaces_ = has_interfaces_ || material.is_interface();
      has_uncounted_ = has_uncounted_ || material.passes_uncounted;
      const bool has_counted_cuts = shape.alpha != desc::kNone && shape.alpha_counted;
      has_interfaces_ = has_interfaces_ || has_counted_cuts;
      has_counted_interfaces_ = has_counted_interfaces_ || material.adds_edge || has_counted_cuts;
    }
    if (!material.needs_derivatives()) geometry_->leave_out_derivatives(surfaces_.size());
    surfaces_.push_back({&material, nullptr, shared_interface(media),
                         static_cast<std::uint32_t>(surfaces_.size()),
                         static_cast<std::uint32_t>(shape.material)});
  };
  surfaces_.reserve(geometry_->shape_count());
  for (const desc::Shape& shape : description.shapes) add(shape);
  for (const desc::Object& object : description.objects) {
    for (const desc::Shape& shape : object.shapes) {
      if (shape.emission && geometry_->has_shape(surfaces_.size())) {
        warnings.add(kInstanced, shape.emission->where, "instanced surfaces do not emit light");
      }
      add(shape);
    }
  }
}

void Scene::name_things(const desc::SceneDesc& description) {
  const auto name_object = [&](const std::string& name) {
    object_names_.push_back(name.empty() ? "shape-" + std::to_string(object_names_.size() + 1)
                                         : name);
  };
  for (const desc::Shape& shape : description.shapes) name_object(shape.name);
  for (const desc::Object& object : description.objects) {
    for (const desc::Shape& shape : object.shapes) {
      name_object(shape.name.empty() ? object.name : shape.name);
    }
  }
  for (const desc::Material& material : description.materials) {
    material_names_.push_back(material.name.empty()
                                  ? "material-" + std::to_string(material_names_.size() + 1)
                                  : material.name);
  }
}

void Scene::build_lights(const desc::SceneDesc& description, Warnings& warnings) {
  std::optional<BoundingSphere> receivers;
  if (!geometry_->receivers().isEmpty()) receivers = sphere_around(geometry_->receivers());
  const auto add = [this](std::unique_ptr<Light> light) {
    light->index = static_cast<std::uint32_t>(lights_.size());
    lights_.push_back(std::move(light));
    return lights_.back().get();
  };
  for (const desc::Light& described : description.lights) {
    auto made =
        make_light(described, {bounding_sphere_, receivers, description.embedded_files}, warnings);
    if (!made) continue;
    Light* light = add(std::move(made));
    light->medium = medium(described.medium);
    if (light->at_infinity() && !light->discrete_position()) infinite_lights_.push_back(light);
  }
  for (std::size_t i = 0; i < description.shapes.size(); ++i) {
    const desc::Shape& shape = description.shapes[i];
    if (!shape.emission || !geometry_->has_shape(i)) continue;
    if (surfaces_[i].material->max_lobes() == 0) {
      warnings.add(kNoMaterial, shape.emission->where,
                   "a surface without material cannot emit: give it a black matte one");
      continue;
    }
    auto sampler = geometry_->make_sampler(i);
    if (!sampler) {
      const bool is_curve = shape.node.is("curves");
      warnings.add(
          kNoEmitter, shape.emission->where,
          is_curve ? "curves cannot emit light" : "the surface has no area and emits no light");
      continue;
    }
    auto light = make_surface_light(*shape.emission, *sampler, textures_, receivers);
    emitters_.push_back(std::move(sampler));
    if (!light) continue;
    light->medium = medium(shape.outside);
    surfaces_[i].light = add(std::move(light));
  }
  if (lights_.empty()) {
    warnings.add(kNoLight, {std::make_shared<const std::string>(source_), 0, 0},
                 "there is no light in this scene: its picture is black");
  }
}

/// Largest coordinate at which rays start that have not scattered in a medium.
double Scene::reach_of_rays() const {
  double reach = std::max(reach_of(bounds_), reach_of(camera_->bounds()));
  for (const std::unique_ptr<Light>& light : lights_) {
    if (const auto extent = light->bounds()) {
      reach = std::max(reach, reach_of(extent->box));
    } else {
      const Vec3d center(bounding_sphere_.center);
      // The border of a disk that touches the sphere is √2 radii away.
      reach = std::max(reach, reach_of(center, center) + 1.5 * double{bounding_sphere_.radius});
    }
  }
  return reach;
}

bool Scene::intersect(const Ray& ray, Hit& hit) const {
  if (!geometry_->intersect(ray, hit)) return false;
  complete(hit);
  return true;
}

std::optional<Hit> Scene::recall(const GeometryHit& hit) const {
  if (!geometry_->has_place_of(hit)) return std::nullopt;
  std::optional<Hit> result(std::in_place);
  static_cast<GeometryHit&>(*result) = hit;
  complete(*result);
  return result;
}

bool Hit::is_interface() const { return light == nullptr && material->is_interface(); }

std::optional<SurfaceDerivatives> Scene::derivatives(const Hit& hit) const {
  return geometry_->derivatives(hit);
}

void Scene::complete(Hit& hit) const {
  const Surface& surface = surfaces_[hit.shape];
  hit.material = surface.material;
  hit.light = surface.light;
  hit.media = surface.media;
  hit.object_id = surface.object_id;
  hit.material_id = surface.material_id;
}

std::optional<Hit> Scene::intersect(const Ray& ray) const {
  std::optional<Hit> hit(std::in_place);
  if (!intersect(ray, *hit)) hit.reset();
  return hit;
}

bool Scene::occluded(const Ray& ray) const { return geometry_->occluded(ray); }
bool Scene::can_trace(const Ray& ray) const { return geometry_->can_trace(ray); }
void Scene::log_rays(RayLog* log) { geometry_->log_rays(log); }
void Scene::replay(const RayLog& log) const { geometry_->replay(log); }

}  // namespace ajar
