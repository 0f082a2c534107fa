#include "scene/emission/registry.h"

namespace ajar {

// Each is defined in the file of its name. Listed by hand, because a linker drops self-registering
// objects of a library.
EmissionModel area_emission();

const std::vector<EmissionModel>& emission_models() {
  static const std::vector<EmissionModel> kModels{area_emission()};
  return kModels;
}

}  // namespace ajar
