#include "scene/light/light.h"

#include "scene/coordinate_limit.h"
#include "scene/light/models.h"

namespace ajar {

namespace {

constexpr WarningKind kNotTurned{Effect::Light,
                                 "lights have transforms that cannot be inverted in single "
                                 "precision: their rotation is ignored"};

struct MakeLight {
  const desc::Light& light;
  const BoundingSphere& bounds;
  Warnings& warnings;
  LightPlacement at;

  Map load(const std::string& path, MapEdge edge) const {
    return load_map(path, edge, light.where, warnings);
  }

  std::unique_ptr<Light> operator()(const desc::PointLight& node) const {
    return make_point_light(node, at);
  }
  std::unique_ptr<Light> operator()(const desc::SpotLight& node) const {
    return make_spot_light(node, at);
  }
  std::unique_ptr<Light> operator()(const desc::DistantLight& node) const {
    return make_distant_light(node, at, bounds);
  }
  std::unique_ptr<Light> operator()(const desc::InfiniteLight& node) const {
    const Spectrum radiance = rgb_spectrum(node.radiance);
    if (node.image.empty()) return make_constant_environment(radiance, bounds);
    return make_environment_map(radiance, load(node.image, MapEdge::Repeat), at, bounds);
  }
  std::unique_ptr<Light> operator()(const desc::GoniometricLight& node) const {
    if (node.image.empty()) return make_point_light({node.intensity}, at);
    return make_goniometric_light(node, load(node.image, MapEdge::Repeat), at);
  }
  std::unique_ptr<Light> operator()(const desc::ProjectionLight& node) const {
    if (node.image.empty()) {
      return make_projection_light(node, Map(1, 1, {Spectrum(1.F)}, MapEdge::Clamp), at);
    }
    return make_projection_light(node, load(node.image, MapEdge::Clamp), at);
  }
};

}  // namespace

EndpointPoint Light::at_direction(const Vec3& w) const { return EndpointPoint::at_infinity(w); }

std::unique_ptr<Light> make_light(const desc::Light& light, const BoundingSphere& bounds,
                                  Warnings& warnings) {
  LightPlacement at{transform_point(light.to_world, Vec3(0.F)), DirectionMap()};
  if (DirectionMap::invertible(light.to_world)) {
    at.directions = DirectionMap(light.to_world);
  } else {
    warnings.add(kNotTurned, light.where,
                 "the transform of the light cannot be inverted in single precision; its rotation "
                 "is ignored");
  }
  auto made = std::visit(MakeLight{light, bounds, warnings, at}, light.node);
  if (const auto extent = made->bounds())
    check_reach(light.where, "the light", reach_of(extent->box));
  return made;
}

}  // namespace ajar
