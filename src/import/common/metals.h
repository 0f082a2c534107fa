#pragma once
#include <optional>
#include <string_view>

#include "core/vector.h"

namespace ajar {

enum class MetalQuantity { Eta, K };

/// Linear RGB of the measured refractive index or extinction coefficient of a metal given by its
/// chemical symbol (Ag Al Au Cr Cu Ni W); empty for others.
std::optional<Vec3d> metal_rgb(std::string_view symbol, MetalQuantity quantity);

/// Colour in daylight (`sampled_to_rgb_in_daylight`).
std::optional<Vec3d> metal_rgb_in_daylight(std::string_view symbol, MetalQuantity quantity);

/// `metal_rgb` for a file or spectrum name as scenes use them: "spds/metals/Au.eta.spd",
/// "Cu.k.spd", "metal-Cu-eta". Empty if it names no metal we know.
std::optional<Vec3d> metal_rgb_by_file_name(std::string_view name);

}  // namespace ajar
