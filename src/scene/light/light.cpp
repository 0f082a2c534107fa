#include "scene/light/light.h"

#include <algorithm>
#include <stdexcept>

#include "scene/coordinate_limit.h"
#include "scene/light/inputs.h"
#include "scene/light/make_light.h"

namespace ajar {

EndpointPoint Light::at_direction(const Vec3& w) const { return EndpointPoint::at_infinity(w); }

EndpointPoint Light::only_point() const {
  throw std::logic_error("bug: this light has more than one point");
}

std::unique_ptr<Light> make_light(const desc::Light& light, const BoundingSphere& bounds,
                                  Warnings& warnings) {
  return make_light(light, {bounds, std::nullopt, {}}, warnings);
}

std::unique_ptr<Light> make_light(const desc::Light& light, const LightSurroundings& surroundings,
                                  Warnings& warnings) {
  const std::vector<LightModel>& models = light_models();
  const auto model = std::find_if(models.begin(), models.end(), [&](const LightModel& registered) {
    return light.node.is(registered.model.name);
  });
  if (model == models.end()) throw SceneError(light.where, "this light has no model");
  auto made = model->make(LightInputs(light, surroundings, warnings));
  if (const auto extent = made->bounds())
    check_reach(light.where, "the light", reach_of(extent->box));
  return made;
}

}  // namespace ajar
