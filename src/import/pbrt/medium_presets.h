#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/desc/scene_desc.h"

namespace ajar::pbrt {

/// Measured scattering of a substance, 1/mm.
struct MediumPreset {
  desc::Rgb sigma_s;  ///< reduced
  desc::Rgb sigma_a;
};
std::optional<MediumPreset> medium_preset(std::string_view name);
std::vector<std::string> medium_preset_names();

}  // namespace ajar::pbrt
