#pragma once
#include <cmath>
#include <concepts>

namespace ajar {

/// Display encoding of a linear value in [0, 1] and its inverse. Source: IEC 61966-2-1 (piecewise).
inline float srgb_from_linear(float linear) {
  return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1.F / 2.4F) - 0.055F;
}
template <std::floating_point Real>
Real linear_from_srgb(Real encoded) {
  return encoded <= Real(0.04045) ? encoded / Real(12.92)
                                  : std::pow((encoded + Real(0.055)) / Real(1.055), Real(2.4));
}

}  // namespace ajar
