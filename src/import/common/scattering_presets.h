#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/vector.h"

namespace ajar {

/// What is known of a medium by name: reduced scattering and absorption, linear RGB in 1/mm.
struct ScatteringPreset {
  Vec3 sigma_s;
  Vec3 sigma_a;
};

/// "Skin1", "wholemilk", …, in large or small letters. Source: Jensen et al. 2001, A practical
/// model for subsurface light transport, figure 5.
std::optional<ScatteringPreset> find_scattering_preset(std::string_view name);
std::vector<std::string> scattering_preset_names();

}  // namespace ajar
