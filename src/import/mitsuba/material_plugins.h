#pragma once
#include <span>
#include <string_view>

#include "import/mitsuba/materials.h"

namespace ajar::mitsuba {

/// Inputs of a material.
struct MaterialInputs {
  Arguments& arguments;
  MaterialTable& materials;
  TextureTable& textures;

  Context& context() const { return arguments.context(); }
  const SourceLocation& where() const { return arguments.where(); }
};

/// A type of `<bsdf>` that we know.
struct MaterialPlugin {
  std::string_view type;
  Surface (*make)(const MaterialInputs& in);
};

std::span<const MaterialPlugin> material_plugins();
/// Null for others.
const MaterialPlugin* find_material_plugin(std::string_view type);

// In diffuse_materials.cpp:
Surface make_diffuse(const MaterialInputs& in);
Surface make_rough_diffuse(const MaterialInputs& in);
Surface make_diffuse_transmitter(const MaterialInputs& in);
Surface make_principled(const MaterialInputs& in);
Surface make_thin_principled(const MaterialInputs& in);
// In specular_materials.cpp:
Surface make_dielectric(const MaterialInputs& in);
Surface make_thin_dielectric(const MaterialInputs& in);
Surface make_rough_dielectric(const MaterialInputs& in);
Surface make_conductor(const MaterialInputs& in);
Surface make_rough_conductor(const MaterialInputs& in);
/// Metals of Mitsuba 0.x variants for glints: GGX alone, and "R0" in place of an index.
Surface make_ggx_conductor(const MaterialInputs& in);
// In coated_materials.cpp:
Surface make_plastic(const MaterialInputs& in);
Surface make_rough_plastic(const MaterialInputs& in);
Surface make_polarized_plastic(const MaterialInputs& in);
Surface make_coating(const MaterialInputs& in);
Surface make_rough_coating(const MaterialInputs& in);
Surface make_phong(const MaterialInputs& in);
Surface make_ward(const MaterialInputs& in);
// In nested_materials.cpp:
Surface make_null(const MaterialInputs& in);
Surface make_two_sided(const MaterialInputs& in);
Surface make_mask(const MaterialInputs& in);
Surface make_bump_map(const MaterialInputs& in);
Surface make_normal_map(const MaterialInputs& in);
Surface make_blend(const MaterialInputs& in);
Surface make_mixture(const MaterialInputs& in);

}  // namespace ajar::mitsuba
