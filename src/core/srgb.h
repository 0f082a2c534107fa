#pragma once
#include <cmath>

namespace ajar {

/// Display encoding of a linear value in [0, 1] and its inverse. Source: IEC 61966-2-1 (piecewise).
inline float srgb_from_linear(float linear) {
  return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1.F / 2.4F) - 0.055F;
}
inline float linear_from_srgb(float encoded) {
  return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

}  // namespace ajar
