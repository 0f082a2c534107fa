#pragma once
#include <algorithm>

#include "core/vector.h"

namespace ajar {

/// A part of the unit interval: the uniform numbers that make one choice.
struct UnitInterval {
  double begin = 0.0;
  double size = 1.0;

  /// The part `inner` of this one.
  UnitInterval part(const UnitInterval& inner) const {
    return {begin + size * inner.begin, size * inner.size};
  }
  /// The number at `u` in [0, 1) of it: inverse of the choice. Some roundings off its ends, where
  /// the choice may differ.
  float at(float u) const {
    if (size == 1.0) return u;
    const double margin = std::min(0.25 * size, 0x1p-22);
    const double place = begin + margin + static_cast<double>(u) * (size - 2.0 * margin);
    return std::clamp(static_cast<float>(place), 0.F, kOneMinusEpsilon);
  }
};

/// Chooses between two ways to sample with densities (or probabilities) `first` and `second`, not
/// both zero: true for the first. `u` decides, and is remapped to [0, 1).
inline bool came_first(double first, double second, float& u) {
  const double share = first / (first + second);
  const auto v = static_cast<double>(u);
  const bool is_first = v < share;
  const double stretched = is_first ? v / share : (v - share) / (1.0 - share);
  u = std::min(static_cast<float>(stretched), kOneMinusEpsilon);
  return is_first;
}

}  // namespace ajar
