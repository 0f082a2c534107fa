#include <limits>

#include "scene/light/bounding_disk.h"
#include "scene/light/models.h"

namespace ajar {

namespace {

/// Parallel light from one direction.
class DistantLight final : public Light {
 public:
  DistantLight(const Spectrum& irradiance, const Vec3& toward, const BoundingSphere& bounds)
      : irradiance_(irradiance), toward_(toward), disk_(bounds) {}

  bool at_infinity() const override { return true; }
  bool discrete_position() const override { return true; }
  EndpointPoint only_point() const override { return EndpointPoint::at_infinity(toward_); }
  Spectrum power() const override { return irradiance_ * disk_.area(); }

  std::optional<EmissionSample> sample_emission(const EmissionUniforms& u) const override {
    if (irradiance_.is_black()) return std::nullopt;
    return EmissionSample{
        EndpointPoint::at_infinity(toward_), disk_.sample(toward_, u.position), -toward_,
        irradiance_ * disk_.area(),          Pdf<VertexMeasure>(1.F),           disk_.pdf()};
  }
  EmissionPdf emission_pdf(const EndpointPoint& /*point*/, const Vec3& /*w*/) const override {
    return {Pdf<VertexMeasure>(1.F), disk_.pdf()};
  }
  Spectrum emitted(const EndpointPoint& /*point*/, const Vec3& /*w*/) const override {
    return irradiance_;
  }
  std::optional<ConnectionSample> sample_connection(
      const Vec3& /*reference*/, const ConnectionUniforms& /*u*/) const override {
    if (irradiance_.is_black()) return std::nullopt;
    return ConnectionSample{EndpointPoint::at_infinity(toward_), toward_,
                            std::numeric_limits<float>::infinity(), irradiance_,
                            Pdf<VertexMeasure>(1.F)};
  }
  Pdf<VertexMeasure> connection_pdf(const Vec3& /*reference*/,
                                    const EndpointPoint& /*point*/) const override {
    return Pdf<VertexMeasure>(1.F);
  }
  std::optional<EmissionUniforms> invert_emission(const EndpointPoint& /*point*/,
                                                  const Vec3& through, const Vec3& /*w*/,
                                                  const EmissionUniforms& fresh) const override {
    const std::optional<Vec2> position = disk_.invert(toward_, through);
    if (!position) return std::nullopt;
    return EmissionUniforms{fresh.primitive, *position, fresh.direction};
  }
  std::optional<ConnectionUniforms> invert_connection(
      const Vec3& /*reference*/, const EndpointPoint& /*point*/,
      const ConnectionUniforms& fresh) const override {
    return fresh;
  }

 private:
  Spectrum irradiance_;
  Vec3 toward_;  ///< unit, to the light
  BoundingDisk disk_;
};

}  // namespace

LightModel distant_light() {
  return {{.name = "distant",
           .summary = "parallel light from the direction of z",
           .source = "",
           .parameters = {declare::emission("irradiance", "W/m2", "on a surface that faces it")}},
          [](const LightInputs& in) -> std::unique_ptr<Light> {
            return std::make_unique<DistantLight>(
                in.color("irradiance"), in.at().directions.to_world({0.F, 0.F, 1.F}), in.bounds());
          }};
}

}  // namespace ajar
