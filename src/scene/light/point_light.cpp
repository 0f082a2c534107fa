#include "core/warp.h"
#include "scene/light/models.h"
#include "scene/light/point_connection.h"

namespace ajar {

namespace {

/// Isotropic point light.
class PointLight final : public Light {
 public:
  PointLight(const Spectrum& intensity, const Vec3& position, const Aim& aim)
      : intensity_(intensity), position_(position), aim_(aim) {}

  bool at_infinity() const override { return false; }
  bool discrete_position() const override { return true; }
  EndpointPoint only_point() const override { return EndpointPoint::at(position_); }
  Spectrum power() const override { return intensity_ * (4.F * kPi); }
  std::optional<LightBounds> bounds() const override {
    return point_bounds(position_, luminance(intensity_));
  }

  std::optional<EmissionSample> sample_emission(const EmissionUniforms& u) const override {
    if (intensity_.is_black()) return std::nullopt;
    const Vec3 w = aim_.sample(position_, u.direction, warp::uniform_sphere);
    const Pdf<Departure> departure = aim_.pdf(position_, w, kOwn);
    return EmissionSample{
        EndpointPoint::at(position_), position_, w, intensity_ / departure.value(),
        Pdf<VertexMeasure>(1.F),      departure};
  }
  EmissionPdf emission_pdf(const EndpointPoint& /*point*/, const Vec3& w) const override {
    return {Pdf<VertexMeasure>(1.F), aim_.pdf(position_, w, kOwn)};
  }
  Spectrum emitted(const EndpointPoint& /*point*/, const Vec3& /*w*/) const override {
    return intensity_;
  }
  std::optional<ConnectionSample> sample_connection(
      const Vec3& reference, const ConnectionUniforms& /*u*/) const override {
    return connect_to_point(position_, reference, [&](const Vec3&) { return intensity_; });
  }
  Pdf<VertexMeasure> connection_pdf(const Vec3& /*reference*/,
                                    const EndpointPoint& /*point*/) const override {
    return Pdf<VertexMeasure>(1.F);
  }
  std::optional<EmissionUniforms> invert_emission(const EndpointPoint& /*point*/,
                                                  const Vec3& /*through*/, const Vec3& w,
                                                  const EmissionUniforms& fresh) const override {
    return EmissionUniforms{
        fresh.primitive, fresh.position,
        aim_.invert(position_, w, kOwn, warp::uniform_sphere_inverse(w), fresh.direction.x)};
  }
  std::optional<ConnectionUniforms> invert_connection(
      const Vec3& /*reference*/, const EndpointPoint& /*point*/,
      const ConnectionUniforms& fresh) const override {
    return fresh;
  }

 private:
  Spectrum intensity_;
  static constexpr Pdf<Departure> kOwn{warp::kUniformSpherePdf};

  Vec3 position_;
  Aim aim_;
};

}  // namespace

std::unique_ptr<Light> make_point_light(const Spectrum& intensity, const LightPlacement& at,
                                        const Aim& aim) {
  return std::make_unique<PointLight>(intensity, at.position, aim);
}

LightModel point_light() {
  return {{.name = "point",
           .summary = "the same in all directions from one point",
           .source = "",
           .parameters = {declare::emission("intensity", "W/sr", "radiant intensity")}},
          [](const LightInputs& in) {
            return make_point_light(in.color("intensity"), in.at(), in.aim());
          }};
}

}  // namespace ajar
