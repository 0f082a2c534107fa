#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "import/pbrt/textures.h"

namespace ajar::pbrt {

/// A node of the nearest equivalent of a material of pbrt's that we cannot render, after a warning:
/// hair, subsurface scattering, measured and tabulated materials. Empty for other types.
std::optional<desc::Node> make_stand_in(const SourceLocation& where, const std::string& type,
                                        const TextureParameters& parameters);
std::vector<std::string> stand_in_types(Dialect dialect);

}  // namespace ajar::pbrt
