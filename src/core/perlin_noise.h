#pragma once
#include "core/vector.h"

namespace ajar {

/// Gradient noise with period 256, zero at integer points, about −1 to 1.
/// Source: Perlin 2002, "Improving noise"; hashing and gradients as in pbrt-v3, section 10.6.
float noise(const Vec3& p);
/// Sum of `octaves` noises, each 1.99 times finer and `roughness` times weaker than the one before.
float fbm(const Vec3& p, float roughness, int octaves);
/// Turbulence: the sum of absolute values. Source: pbrt-v3, section 10.6.4.
float turbulence(const Vec3& p, float roughness, int octaves);

}  // namespace ajar
