#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/vector.h"
#include "import/common/metals.h"

/// The spectra that pbrt-v4 knows by name.
namespace ajar::pbrt {

/// Linear RGB, as daylight shows it, of "metal-Cu-eta", "metal-Au-k", …
std::optional<Vec3d> named_metal(std::string_view name);
/// Index of refraction of "glass-BK7", … at the yellow line of helium.
std::optional<float> named_glass(std::string_view name);
/// XYZ, with Y = 1, of "stdillum-D65", "illum-acesD60", …
std::optional<Vec3d> named_illuminant(std::string_view name);

std::vector<std::string> spectrum_names();

}  // namespace ajar::pbrt
