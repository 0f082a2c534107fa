#include "scene/material/registry.h"

namespace ajar {

// Each is defined in the file of its name. Listed by hand, because a linker drops self-registering
// objects of a library.
MaterialModel coated_conductor_material();
MaterialModel coated_diffuse_material();
MaterialModel composite_material();
MaterialModel conductor_material();
MaterialModel dielectric_material();
MaterialModel diffuse_material();
MaterialModel interface_material();
MaterialModel mirror_material();
MaterialModel mix_material();
MaterialModel plastic_material();
MaterialModel principled_material();
MaterialModel translucent_material();

const std::vector<MaterialModel>& material_models() {
  static const std::vector<MaterialModel> kModels{
      coated_conductor_material(), coated_diffuse_material(), composite_material(),
      conductor_material(),        dielectric_material(),     diffuse_material(),
      interface_material(),        mirror_material(),         mix_material(),
      plastic_material(),          principled_material(),     translucent_material()};
  return kModels;
}

}  // namespace ajar
