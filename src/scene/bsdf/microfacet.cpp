#include "scene/bsdf/microfacet.h"

namespace ajar {
namespace {
constexpr float kInvSqrtPi = 0.56418958354775628695F;
}  // namespace

float Microfacets::beckmann_projected_area(float z, float s) {
  // |cos θ| (1 + Λ) with Λ = (erf a − 1)/2 + exp(−a²)/(2 a √π) and a = z/s, multiplied out so that
  // neither the horizon (z = 0) nor the normal (s = 0) divides by zero.
  if (s <= 0.1F * z) return z;  // there Λ < 1e-46
  const float a = z / s;
  return 0.5F * (z * (1.F + std::erf(a)) + s * kInvSqrtPi * std::exp(-a * a));
}

Vec3 Microfacets::beckmann_visible(const Vec3& w, const Vec2& u) {
  // Slope across the view: Gaussian, independent of the view.
  const float across =
      inverse_erf(std::clamp(2.F * u.y - 1.F, -kOneMinusEpsilon, kOneMinusEpsilon));
  const float sin_theta = std::sqrt(w.x * w.x + w.y * w.y);
  if (sin_theta < 1e-5F) {
    const float along =
        inverse_erf(std::clamp(2.F * u.x - 1.F, -kOneMinusEpsilon, kOneMinusEpsilon));
    return {along, across, 1.F};
  }
  // Slope t toward the view: density ∝ (c + t) exp(−t²) for t > −c, c = cot θ, whose complementary
  // cumulative distribution is [c erfc(t)/2 + exp(−t²)/(2√π)] / (its value at t = −c).
  const float c = w.z / sin_theta;
  const auto upper = [c](float t) {
    return 0.5F * (c * std::erfc(t) + kInvSqrtPi * std::exp(-t * t));
  };
  float low = -std::min(c, 6.F);
  float high = 6.F;
  const float target = std::max(1.F - u.x, 1e-7F) * upper(low);
  float t = std::clamp(0.5F * low + 0.4F, low, high);
  for (int i = 0; i < 30 && high - low > 1e-6F; ++i) {
    const float excess = upper(t) - target;
    if (std::abs(excess) <= 2e-7F * target) break;
    (excess > 0.F ? low : high) = t;
    const float slope = (c + t) * std::exp(-t * t) * kInvSqrtPi;
    const float newton = t + excess / slope;
    t = newton > low && newton < high ? newton : 0.5F * (low + high);
  }
  const Vec2 direction(w.x / sin_theta, w.y / sin_theta);
  return {t * direction.x - across * direction.y, t * direction.y + across * direction.x, 1.F};
}

Vec2 Microfacets::beckmann_inverse(const Vec3& w, const Vec3& m) {
  const auto unit = [](double u) {
    return std::clamp(static_cast<float>(u), 0.F, kOneMinusEpsilon);
  };
  // In double precision: single precision has too few numbers next to one for the tails.
  const auto below = [&](double slope) { return unit(0.5 * std::erfc(-slope)); };
  const double z = std::max(m.z, 1e-12F);
  const Vec2 slope(static_cast<float>(m.x / z), static_cast<float>(m.y / z));
  const float sin_theta = std::sqrt(w.x * w.x + w.y * w.y);
  if (sin_theta < 1e-5F) return {below(slope.x), below(slope.y)};
  const Vec2 direction(w.x / sin_theta, w.y / sin_theta);
  const double c = w.z / sin_theta;
  const auto upper = [c](double t) {
    return 0.5 * (c * std::erfc(t) + double{kInvSqrtPi} * std::exp(-t * t));
  };
  const double t = slope.x * direction.x + slope.y * direction.y;
  const float across = slope.y * direction.x - slope.x * direction.y;
  return {unit(1.0 - upper(t) / upper(-std::min(c, 6.0))), below(across)};
}

float inverse_erf(float x) {
  // Giles 2010, "Approximating the erfinv function", single precision.
  float w = -std::log((1.F - x) * (1.F + x));
  float p;
  if (w < 5.F) {
    w -= 2.5F;
    p = 2.81022636e-08F;
    for (const float k : {3.43273939e-07F, -3.5233877e-06F, -4.39150654e-06F, 0.00021858087F,
                          -0.00125372503F, -0.00417768164F, 0.246640727F, 1.50140941F}) {
      p = k + p * w;
    }
  } else {
    w = std::sqrt(w) - 3.F;
    p = -0.000200214257F;
    for (const float k : {0.000100950558F, 0.00134934322F, -0.00367342844F, 0.00573950773F,
                          -0.0076224613F, 0.00943887047F, 1.00167406F, 2.83297682F}) {
      p = k + p * w;
    }
  }
  return p * x;
}

float roughness_to_alpha(float roughness) {
  const float x = std::log(roughness > 1e-3F ? std::min(roughness, 1e3F) : 1e-3F);
  return 1.62142F + x * (0.819955F + x * (0.1734F + x * (0.0171201F + x * 0.000640711F)));
}

}  // namespace ajar
