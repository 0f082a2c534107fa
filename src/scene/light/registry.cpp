#include "scene/light/registry.h"

namespace ajar {

// Each is defined in the file of its name. Listed by hand, because a linker drops self-registering
// objects of a library.
LightModel distant_light();
LightModel environment_light();
LightModel goniometric_light();
LightModel point_light();
LightModel projection_light();
LightModel sky_light();
LightModel spot_light();

const std::vector<LightModel>& light_models() {
  static const std::vector<LightModel> kModels{
      distant_light(),    environment_light(), goniometric_light(), point_light(),
      projection_light(), sky_light(),         spot_light()};
  return kModels;
}

}  // namespace ajar
