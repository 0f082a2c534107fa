#include "import/mitsuba/material_plugins.h"

#include <algorithm>
#include <array>

namespace ajar::mitsuba {
namespace {

constexpr std::array<MaterialPlugin, 27> kPlugins = {{{"diffuse", make_diffuse},
                                                      {"roughdiffuse", make_rough_diffuse},
                                                      {"difftrans", make_diffuse_transmitter},
                                                      {"principled", make_principled},
                                                      {"principledthin", make_thin_principled},
                                                      {"dielectric", make_dielectric},
                                                      {"thindielectric", make_thin_dielectric},
                                                      {"roughdielectric", make_rough_dielectric},
                                                      {"conductor", make_conductor},
                                                      {"roughconductor", make_rough_conductor},
                                                      {"roughconductorGGX", make_ggx_conductor},
                                                      {"plastic", make_plastic},
                                                      {"roughplastic", make_rough_plastic},
                                                      {"pplastic", make_polarized_plastic},
                                                      {"coating", make_coating},
                                                      {"roughcoating", make_rough_coating},
                                                      {"phong", make_phong},
                                                      {"ward", make_ward},
                                                      {"null", make_null},
                                                      {"twosided", make_two_sided},
                                                      {"mask", make_mask},
                                                      {"bumpmap", make_bump_map},
                                                      {"bump", make_bump_map},
                                                      {"normalmap", make_normal_map},
                                                      {"blendbsdf", make_blend},
                                                      {"mixturebsdf", make_mixture},
                                                      {"mixture", make_mixture}}};

}  // namespace

std::span<const MaterialPlugin> material_plugins() { return kPlugins; }

const MaterialPlugin* find_material_plugin(std::string_view type) {
  const auto found =
      std::find_if(kPlugins.begin(), kPlugins.end(),
                   [&](const MaterialPlugin& plugin) { return plugin.type == type; });
  return found == kPlugins.end() ? nullptr : &*found;
}

}  // namespace ajar::mitsuba
