#include "scene/emission/emission.h"

#include <algorithm>

#include "scene/emission/inputs.h"

namespace ajar {

std::unique_ptr<Light> make_surface_light(const desc::Emission& emission,
                                          const SurfaceSampler& surface,
                                          const TextureList& textures,
                                          const std::optional<BoundingSphere>& receivers) {
  const std::vector<EmissionModel>& models = emission_models();
  const auto model = std::find_if(
      models.begin(), models.end(),
      [&](const EmissionModel& registered) { return emission.node.is(registered.model.name); });
  if (model == models.end()) throw SceneError(emission.where, "this emission has no model");
  return model->make(EmissionInputs(emission, surface, textures, receivers));
}

}  // namespace ajar
