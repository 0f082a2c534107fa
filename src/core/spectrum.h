#pragma once
#include <algorithm>
#include <cmath>

namespace ajar {

/// A radiometric quantity in four float lanes. Lanes 0, 1, 2 hold linear Rec. 709 RGB and lane 3 is
/// unused (kept at zero); only leaves (textures, emission, film) give the lanes their meaning, so
/// that light transport works lane by lane whatever they stand for.
class Spectrum {
 public:
  using Lanes = float __attribute__((vector_size(16)));

  constexpr Spectrum() : lanes_{0.F, 0.F, 0.F, 0.F} {}
  constexpr explicit Spectrum(float all) : lanes_{all, all, all, 0.F} {}
  constexpr Spectrum(float r, float g, float b) : lanes_{r, g, b, 0.F} {}
  constexpr explicit Spectrum(Lanes lanes) : lanes_(lanes) {}

  float operator[](int lane) const { return lanes_[lane]; }
  void set(int lane, float value) { lanes_[lane] = value; }
  constexpr Lanes lanes() const { return lanes_; }

  Spectrum& operator+=(const Spectrum& o) {
    lanes_ += o.lanes_;
    return *this;
  }
  Spectrum& operator-=(const Spectrum& o) {
    lanes_ -= o.lanes_;
    return *this;
  }
  Spectrum& operator*=(const Spectrum& o) {
    lanes_ *= o.lanes_;
    return *this;
  }
  Spectrum& operator*=(float s) {
    lanes_ *= s;
    return *this;
  }
  Spectrum& operator/=(float s) {
    lanes_ *= 1.F / s;
    return *this;
  }

  friend Spectrum operator+(Spectrum a, const Spectrum& b) { return a += b; }
  friend Spectrum operator-(Spectrum a, const Spectrum& b) { return a -= b; }
  friend Spectrum operator*(Spectrum a, const Spectrum& b) { return a *= b; }
  friend Spectrum operator*(Spectrum a, float s) { return a *= s; }
  friend Spectrum operator*(float s, Spectrum a) { return a *= s; }
  friend Spectrum operator/(Spectrum a, float s) { return a /= s; }
  /// Lane-wise quotient of the three RGB lanes.
  friend Spectrum operator/(const Spectrum& a, const Spectrum& b) {
    return {a[0] / b[0], a[1] / b[1], a[2] / b[2]};
  }
  friend bool operator==(const Spectrum& a, const Spectrum& b) {
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
  }

  bool is_black() const { return lanes_[0] == 0.F && lanes_[1] == 0.F && lanes_[2] == 0.F; }
  bool is_finite() const {
    return std::isfinite(lanes_[0]) && std::isfinite(lanes_[1]) && std::isfinite(lanes_[2]);
  }
  float max() const { return std::max(lanes_[0], std::max(lanes_[1], lanes_[2])); }
  float min() const { return std::min(lanes_[0], std::min(lanes_[1], lanes_[2])); }
  float average() const { return (lanes_[0] + lanes_[1] + lanes_[2]) * (1.F / 3.F); }

 private:
  Lanes lanes_;
};

/// Relative luminance (Rec. 709 / sRGB primaries, D65): the Y of CIE XYZ.
inline float luminance(const Spectrum& s) {
  return 0.212671F * s[0] + 0.715160F * s[1] + 0.072169F * s[2];
}

/// Applies `f` to each RGB lane.
template <typename Function>
Spectrum map_lanes(const Spectrum& s, Function f) {
  return {f(s[0]), f(s[1]), f(s[2])};
}
inline Spectrum exp(const Spectrum& s) {
  return map_lanes(s, [](float x) { return std::exp(x); });
}
inline Spectrum sqrt(const Spectrum& s) {
  return map_lanes(s, [](float x) { return std::sqrt(x); });
}
inline Spectrum clamp(const Spectrum& s, float low, float high) {
  return map_lanes(s, [=](float x) { return std::clamp(x, low, high); });
}
inline Spectrum lerp(const Spectrum& a, const Spectrum& b, const Spectrum& t) {
  return a + t * (b - a);
}

}  // namespace ajar
