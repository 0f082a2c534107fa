#include "scene/emission/registry.h"

namespace ajar {

// Each is defined in the file of its name. A list by hand, because a linker leaves out what a
// library registers by itself.
EmissionModel area_emission();

const std::vector<EmissionModel>& emission_models() {
  static const std::vector<EmissionModel> kModels{area_emission()};
  return kModels;
}

}  // namespace ajar
