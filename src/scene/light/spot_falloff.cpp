#include "scene/light/spot_falloff.h"

#include <algorithm>
#include <cmath>

namespace ajar {

namespace {

/// θ of 1 − cos θ, exact for small angles too.
double angle_of(double a) { return 2.0 * std::asin(std::sqrt(std::clamp(0.5 * a, 0.0, 1.0))); }
float one_minus_cos(double theta) {
  const double sine = std::sin(0.5 * theta);
  return static_cast<float>(2.0 * sine * sine);
}

/// sin x − x, exact for small angles too.
double sine_excess(double x) {
  if (std::abs(x) > 0.5) return std::sin(x) - x;
  // x³/6 (−1 + x²/20 (1 − x²/42 (1 − x²/72 (1 − x²/110)))).
  const double s = x * x;
  return x * s / 6.0 * (-1.0 + s / 20.0 * (1.0 - s / 42.0 * (1.0 - s / 72.0 * (1.0 - s / 110.0))));
}

}  // namespace

SpotFalloff::SpotFalloff(const std::string& name, float inner, float edge)
    : kind_(name == "smoothstep"  ? Kind::Smoothstep
            : name == "quadratic" ? Kind::Quadratic
            : name == "angle"     ? Kind::Angle
                                  : Kind::Quartic),
      inner_(inner),
      edge_(edge),
      inner_angle_(angle_of(static_cast<double>(inner))),
      edge_angle_(angle_of(static_cast<double>(edge))),
      all_beyond_(beyond(inner_angle_)) {
  const float width = edge - inner;
  switch (kind_) {
    case Kind::Quartic:
      integral_ = width * 0.2F;
      break;
    case Kind::Smoothstep:
      integral_ = width * 0.5F;
      break;
    case Kind::Quadratic:
      integral_ = width / 3.F;
      break;
    case Kind::Angle:
      integral_ =
          width > 0.F ? static_cast<float>(all_beyond_ / (edge_angle_ - inner_angle_)) : 0.F;
  }
}

double SpotFalloff::beyond(double theta) const {
  // (θe − θ) cos θ − (sin θe − sin θ), written so that nothing cancels in narrow cones: with
  // d = θe − θ it is cos θ (d − sin d) + sin θ (1 − cos d).
  const double d = edge_angle_ - theta;
  const double half = std::sin(0.5 * d);
  return -std::cos(theta) * sine_excess(d) + std::sin(theta) * 2.0 * half * half;
}

float SpotFalloff::at(float a) const {
  if (kind_ == Kind::Angle) {
    const double theta = angle_of(static_cast<double>(a));
    return static_cast<float>(
        std::clamp((edge_angle_ - theta) / (edge_angle_ - inner_angle_), 0.0, 1.0));
  }
  const float d = delta(a);
  const float squared = d * d;
  if (kind_ == Kind::Smoothstep) return squared * (3.F - 2.F * d);
  return kind_ == Kind::Quadratic ? squared : squared * squared;
}

float SpotFalloff::share(float a) const {
  if (kind_ == Kind::Angle) {
    return static_cast<float>(beyond(angle_of(static_cast<double>(a))) / all_beyond_);
  }
  const float d = delta(a);
  const float cubed = d * d * d;
  if (kind_ == Kind::Smoothstep) return cubed * (2.F - d);
  return kind_ == Kind::Quadratic ? cubed : cubed * d * d;
}

float SpotFalloff::with_share(float share) const {
  const auto wanted = static_cast<double>(share);
  if (kind_ == Kind::Angle) {
    // Newton's steps, halved where they leave the bracket: the share falls all the way.
    double low = inner_angle_;
    double high = edge_angle_;
    const double sought = wanted * all_beyond_;
    double theta = low + (high - low) * (1.0 - std::sqrt(wanted));
    for (int i = 0; i < 40; ++i) {
      const double excess = beyond(theta) - sought;
      (excess > 0.0 ? low : high) = theta;
      const double slope = -(edge_angle_ - theta) * std::sin(theta);
      const double next = theta - excess / slope;
      const double last = theta;
      theta = next > low && next < high ? next : 0.5 * (low + high);
      if (std::abs(theta - last) <= 1e-9 * edge_angle_) break;
    }
    return one_minus_cos(theta);
  }
  double delta = 1.0;
  if (kind_ == Kind::Smoothstep) {
    // Newton's steps from above: the share is convex, so they never fall below the root.
    for (int i = 0; i < 60; ++i) {
      const double cubed = delta * delta * delta;
      const double slope = 6.0 * delta * delta - 4.0 * cubed;
      const double next = delta - (cubed * (2.0 - delta) - wanted) / slope;
      if (!(next < delta && next > 0.0)) break;
      delta = next;
    }
  } else {
    delta = kind_ == Kind::Quadratic ? std::cbrt(wanted) : std::pow(wanted, 0.2);
  }
  return edge_ - (edge_ - inner_) * static_cast<float>(delta);
}

}  // namespace ajar
