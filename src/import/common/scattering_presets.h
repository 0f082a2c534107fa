#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/vector.h"

namespace ajar {

/// Measured media by name: reduced scattering and absorption, linear RGB in 1/mm.
struct ScatteringPreset {
  Vec3 sigma_s;
  Vec3 sigma_a;
};

/// "Skin1", "wholemilk", "Lowfat Milk", …, in large or small letters. Sources: Jensen et al. 2001,
/// A practical model for subsurface light transport, figure 5; Narasimhan et al. 2006, Acquiring
/// scattering properties of participating media by dilution, table 1.
std::optional<ScatteringPreset> find_scattering_preset(std::string_view name);
std::vector<std::string> scattering_preset_names();

}  // namespace ajar
