#pragma once
#include <optional>

#include "import/common/scattering_presets.h"
#include "import/pbrt/context.h"

namespace ajar::pbrt {

/// Milk: pbrt's default for media of its third version, and below surfaces.
ScatteringPreset default_preset();

/// The preset that a scene names at `where`; after a warning the default one for a name that has
/// none, and nothing for no name.
std::optional<ScatteringPreset> preset_named(const Context& context, const SourceLocation& where,
                                             const std::optional<std::string>& name);

}  // namespace ajar::pbrt
