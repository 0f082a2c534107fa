#pragma once
#include <cmath>
#include <cstdint>

namespace ajar {

/// Primary numbers lie on the grid of `to_unit_float`, the multiples of 2⁻²⁴ in [0, 1). Steps are
/// rounded to that grid and added modulo 1 in integers, which is exact: no number can become 1, the
/// uniform distribution stays uniform to the bit, and a step there is as likely as the step back.
/// With plain floats none of the three would hold.
///
/// `number` + `distance` modulo 1, for |distance| ≤ 64.
inline float add_on_unit_circle(float number, float distance) {
  const auto cell = static_cast<std::int32_t>(number * 0x1p24F);
  // Rounded by hand: the library's rounding to integers hinders vectorisation.
  const auto step = static_cast<std::int32_t>(distance * 0x1p24F + std::copysign(0.5F, distance));
  return static_cast<float>((cell + step) & 0xffffff) * 0x1p-24F;
}

}  // namespace ajar
