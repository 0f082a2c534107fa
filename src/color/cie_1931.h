#pragma once
#include <array>

namespace ajar {

/// CIE 1931 2° standard observer, x̄ ȳ z̄ at 5 nm steps.
/// Source: CIE 15:2004 (tables of CVRL, ciexyz31).
inline constexpr double kCieFirst = 360.0;
inline constexpr double kCieLast = 830.0;
inline constexpr double kCieStep = 5.0;
inline constexpr int kCieSamples = 95;
extern const std::array<std::array<double, 3>, kCieSamples> kCie1931;

}  // namespace ajar
