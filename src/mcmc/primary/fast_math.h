#pragma once
#include <bit>
#include <cstdint>

/// Elementary functions without calls or branches, which a compiler can apply to many numbers at
/// once. Mutations need them for every number of every step. Exact to a few units in the seventh
/// digit in the ranges given.
namespace ajar {

/// 2^x for −100 ≤ x ≤ 100.
inline float fast_exp2(float x) {
  // Whole octaves go to the exponent; Taylor's series of the rest, |rest| ≤ ½.
  const float rounded = x + (x < 0.F ? -0.5F : 0.5F);
  const auto whole = static_cast<std::int32_t>(rounded);
  const float y = (x - static_cast<float>(whole)) * 0.69314718F;
  const float rest =
      1.F + y * (1.F + y * (1.F / 2 +
                            y * (1.F / 6 + y * (1.F / 24 + y * (1.F / 120 + y * (1.F / 720))))));
  return rest * std::bit_cast<float>((whole + 127) << 23);
}

/// ln x for normal x > 0.
inline float fast_log(float x) {
  // x = 2^whole · m with m between √½ and √2; ln m = 2 artanh t, t = (m − 1) / (m + 1), |t| <
  // 0.172.
  const auto bits = std::bit_cast<std::int32_t>(x);
  const std::int32_t whole = (bits - 0x3f3504f3) >> 23;
  const float m = std::bit_cast<float>(bits - whole * (1 << 23));
  const float t = (m - 1.F) / (m + 1.F);
  const float s = t * t;
  const float series = 1.F + s * (1.F / 3 + s * (1.F / 5 + s * (1.F / 7 + s * (1.F / 9))));
  return static_cast<float>(whole) * 0.69314718F + 2.F * t * series;
}

/// Sine and cosine for |x| ≤ π/4, by Taylor's series.
inline float fast_sin(float x) {
  const float s = x * x;
  return x * (1.F - s * (1.F / 6 - s * (1.F / 120 - s * (1.F / 5040))));
}
inline float fast_cos(float x) {
  const float s = x * x;
  return 1.F - s * (1.F / 2 - s * (1.F / 24 - s * (1.F / 720 - s * (1.F / 40320))));
}

}  // namespace ajar
