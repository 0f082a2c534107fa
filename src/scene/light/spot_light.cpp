#include <algorithm>
#include <cmath>
#include <string>

#include "core/warp.h"
#include "scene/light/models.h"
#include "scene/light/point_connection.h"
#include "scene/light/spot_falloff.h"

namespace ajar {

namespace {

/// 1 − cos of an angle in degrees, exact for small angles too.
float one_minus_cos(float degrees) {
  const double sine = std::sin(std::clamp(static_cast<double>(degrees), 0.0, 180.0) * M_PI / 360.0);
  return static_cast<float>(2.0 * sine * sine);
}
float one_minus_cos(const Vec3& unit) {
  const float sin_squared = unit.x * unit.x + unit.y * unit.y;
  return unit.z > 0.F ? sin_squared / (1.F + unit.z) : 1.F - unit.z;
}

/// A cone of light around +z that fades between `falloff_start` and `cone_angle`. Emission is
/// sampled in proportion to the intensity.
class SpotLight final : public Light {
 public:
  explicit SpotLight(const LightInputs& in)
      : intensity_(in.color("intensity")),
        at_(in.at()),
        edge_(one_minus_cos(in.node().number("cone_angle"))),
        inner_(std::min(one_minus_cos(in.node().number("falloff_start")), edge_)),
        falloff_(in.node().text("falloff"), inner_, edge_),
        solid_angle_(2.F * kPi * (inner_ + falloff_.integral())) {}

  bool at_infinity() const override { return false; }
  bool discrete_position() const override { return true; }
  EndpointPoint only_point() const override { return EndpointPoint::at(at_.position); }
  Spectrum power() const override { return intensity_ * solid_angle_; }
  std::optional<LightBounds> bounds() const override {
    const Vec3 axis = at_.directions.to_world({0.F, 0.F, 1.F});
    const float edge = widest_angle(axis, edge_);
    const float inner = std::max(std::min(widest_angle(axis, inner_), edge), edge - 0.5F * kPi);
    return LightBounds{
        Box3(at_.position), {axis, inner}, edge - inner, luminance(intensity_), false};
  }

  std::optional<EmissionSample> sample_emission(const EmissionUniforms& u) const override {
    if (intensity_.is_black() || !(solid_angle_ > 0.F)) return std::nullopt;
    const float chance_inner = 2.F * kPi * inner_ / solid_angle_;
    float away = 0.F;  // 1 − cos θ
    if (u.direction.x < chance_inner) {
      away = inner_ * (u.direction.x / chance_inner);
    } else {
      const float v = std::min((u.direction.x - chance_inner) / (1.F - chance_inner), 1.F);
      away = falloff_.with_share(1.F - v);
    }
    const float sine = std::sqrt(std::max(0.F, away * (2.F - away)));
    const float phi = 2.F * kPi * u.direction.y;
    const Vec3 w =
        at_.directions.to_world({sine * std::cos(phi), sine * std::sin(phi), 1.F - away});
    const DirectionMap::Local local = at_.directions.to_local(w);
    const float fade = falloff(local.w);
    if (!(fade > 0.F)) return std::nullopt;
    return EmissionSample{EndpointPoint::at(at_.position),
                          at_.position,
                          w,
                          intensity_ * (solid_angle_ / local.stretch),
                          Pdf<VertexMeasure>(1.F),
                          Pdf<Departure>(fade * local.stretch / solid_angle_)};
  }
  EmissionPdf emission_pdf(const EndpointPoint& /*point*/, const Vec3& w) const override {
    const DirectionMap::Local local = at_.directions.to_local(w);
    const float fade = falloff(local.w);
    const float density = fade > 0.F ? fade * local.stretch / solid_angle_ : 0.F;
    return {Pdf<VertexMeasure>(1.F), Pdf<Departure>(density)};
  }
  Spectrum emitted(const EndpointPoint& /*point*/, const Vec3& w) const override {
    return intensity_ * falloff(at_.directions.to_local(w).w);
  }
  std::optional<ConnectionSample> sample_connection(
      const Vec3& reference, const ConnectionUniforms& /*u*/) const override {
    return connect_to_point(at_.position, reference, [&](const Vec3& w) {
      return intensity_ * falloff(at_.directions.to_local(w).w);
    });
  }
  Pdf<VertexMeasure> connection_pdf(const Vec3& /*reference*/,
                                    const EndpointPoint& /*point*/) const override {
    return Pdf<VertexMeasure>(1.F);
  }
  std::optional<EmissionUniforms> invert_emission(const EndpointPoint& /*point*/,
                                                  const Vec3& /*through*/, const Vec3& w,
                                                  const EmissionUniforms& fresh) const override {
    const Vec3 local = at_.directions.to_local(w).w;
    if (!(falloff(local) > 0.F)) return std::nullopt;
    const float chance_inner = 2.F * kPi * inner_ / solid_angle_;
    const float away = one_minus_cos(local);
    float x = 0.F;
    if (away < inner_) {
      x = chance_inner * (away / inner_);
    } else {
      x = chance_inner + (1.F - falloff_.share(away)) * (1.F - chance_inner);
    }
    return EmissionUniforms{fresh.primitive,
                            fresh.position,
                            {std::min(x, kOneMinusEpsilon), warp::turn_of({local.x, local.y})}};
  }
  std::optional<ConnectionUniforms> invert_connection(
      const Vec3& /*reference*/, const EndpointPoint& /*point*/,
      const ConnectionUniforms& fresh) const override {
    return fresh;
  }

 private:
  /// Largest angle in the world between `axis` and directions `away` = 1 − cos θ from +z, which are
  /// a circle there or, if the light's space is stretched, an ellipse.
  float widest_angle(const Vec3& axis, float away) const {
    const float sine = std::sqrt(std::max(0.F, away * (2.F - away)));
    constexpr int kSteps = 64;
    float widest = 0.F;
    for (int i = 0; i < kSteps; ++i) {
      const float phi = 2.F * kPi * static_cast<float>(i) / kSteps;
      const Vec3 w =
          at_.directions.to_world({sine * std::cos(phi), sine * std::sin(phi), 1.F - away});
      widest = std::max(widest, angle_between(axis, w));
    }
    // Margin for angles between the steps.
    return std::min(widest + 2e-3F, kPi);
  }
  float falloff(const Vec3& local) const {
    const float away = one_minus_cos(local);
    if (!(away < edge_)) return 0.F;
    if (away <= inner_) return 1.F;
    return falloff_.at(away);
  }

  Spectrum intensity_;
  LightPlacement at_;
  float edge_;   ///< 1 − cos of the cone's half angle
  float inner_;  ///< 1 − cos where fading starts
  SpotFalloff falloff_;
  float solid_angle_;  ///< ∫ falloff dω, local
};

}  // namespace

LightModel spot_light() {
  return {
      {.name = "spot",
       .summary = "a cone of light along z from one point, with a soft edge",
       .source = "Pharr et al. 2016, section 12.3.1",
       .parameters = {declare::emission("intensity", "W/sr", "radiant intensity in the middle"),
                      declare::number("cone_angle", "30", "from the axis to where it is dark",
                                      "degrees"),
                      declare::number("falloff_start", "25", "from the axis to where it fades",
                                      "degrees"),
                      choice_parameter("falloff", {"quartic", "smoothstep", "quadratic", "angle"},
                                       "how it fades: with the cosine, or with the angle")}},
      [](const LightInputs& in) -> std::unique_ptr<Light> {
        return std::make_unique<SpotLight>(in);
      }};
}

}  // namespace ajar
