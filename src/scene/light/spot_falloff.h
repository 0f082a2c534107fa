#pragma once
#include <string>

namespace ajar {

/// Falloff of a spot light from 1, inside of a cone, to 0 at the edge of a wider one. Directions
/// are given by a = 1 − cos θ, θ being the angle from the axis: solid angle is 2π da. Sources:
/// pbrt-v3, section 12.3.1 (`quartic`: δ⁴, δ being linear in the cosine); pbrt-v4, section 12.2.1
/// (`smoothstep`: 3δ² − 2δ³); glTF's KHR_lights_punctual (`quadratic`: δ²); Mitsuba's spot
/// (`angle`: linear in θ).
class SpotFalloff {
 public:
  /// `inner` ≤ `edge`, both in a. `name` is one of the four above.
  SpotFalloff(const std::string& name, float inner, float edge);

  /// For a from `inner` to `edge`.
  float at(float a) const;
  /// ∫ at(a) da from `inner` to `edge`.
  float integral() const { return integral_; }
  /// ∫ at(a) da from `a` to the edge, over `integral`.
  float share(float a) const;
  /// The a that has this share.
  float with_share(float share) const;

 private:
  enum class Kind { Quartic, Smoothstep, Quadratic, Angle };
  float delta(float a) const { return (edge_ - a) / (edge_ - inner_); }
  /// ∫ (θ_edge − θ) sin θ dθ from `theta` to the edge.
  double beyond(double theta) const;

  Kind kind_;
  float inner_;
  float edge_;
  double inner_angle_;  ///< radians
  double edge_angle_;
  double all_beyond_;  ///< from the inner angle on
  float integral_;
};

}  // namespace ajar
