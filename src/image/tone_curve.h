#pragma once
#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>
#include <vector>

#include "color/srgb.h"
#include "core/spectrum.h"

namespace ajar {

/// Curve between scene-linear values and the display. `Srgb` (the default) only clamps.
enum class ToneMap { Srgb, Filmic };

/// By name, "srgb" or "filmic"; raises UsageError listing both.
ToneMap tone_map_by_name(std::string_view name);

/// Film-like shoulder and toe on a linear value ≥ 0; the result, still linear, is in [0, 1].
/// Source: Narkowicz 2016, "ACES filmic tone mapping curve", with the factor 0.6 on the input that
/// he gives for matching the exposure of the ACES reference transform.
inline float filmic_curve(float linear) {
  // Beyond this the curve is at its end, and squares would overflow.
  const float x = std::min(0.6F * linear, 1e6F);
  return std::min((x * (2.51F * x + 0.03F)) / (x * (2.43F * x + 0.59F) + 0.14F), 1.F);
}

/// Scene-linear value → display value in [0, 1]. `exposure` in stops (factor 2^exposure). NaN and
/// negative values show as 0, +infinity as the curve's end.
inline float tone_map(float linear, ToneMap curve, float exposure) {
  // Written so that NaN becomes zero; bounds keep infinity times zero away.
  float value =
      linear > 0.F ? std::min(linear, 1e38F) * std::exp2(std::clamp(exposure, -100.F, 100.F)) : 0.F;
  if (curve == ToneMap::Filmic) value = filmic_curve(value);
  return srgb_from_linear(std::min(value, 1.F));
}
inline Spectrum tone_map(const Spectrum& linear, ToneMap curve, float exposure) {
  return map_lanes(linear, [=](float x) { return tone_map(x, curve, exposure); });
}

/// The image that LDR metrics compare: exposure 0, sRGB, clamped to [0, 1] (docs/compare.md).
std::vector<float> to_ldr(std::span<const float> linear);

}  // namespace ajar
