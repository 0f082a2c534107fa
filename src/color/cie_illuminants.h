#pragma once
#include <array>
#include <optional>
#include <string_view>

#include "core/vector.h"

namespace ajar {

/// CIE standard illuminant D65, relative spectral power at 10 nm steps from 360 nm.
/// Source: CIE 15:2004, table T.1; values between are linear.
inline constexpr int kD65Samples = 48;
inline constexpr double kD65Step = 10.0;
extern const std::array<double, kD65Samples> kD65;

/// XYZ, with Y = 1, of an illuminant by its usual name: "A", "D50", "D65", "F1" … "F12", "acesD60".
/// Empty for others. Sources: CIE 15:2004, tables T.3 and T.8.1; SMPTE ST 2065-1.
std::optional<Vec3d> illuminant_xyz(std::string_view name);
/// XYZ of a chromaticity with Y = 1.
Vec3d chromaticity_to_xyz(double x, double y);

}  // namespace ajar
