#include <limits>

#include "core/warp.h"
#include "scene/light/bounding_disk.h"
#include "scene/light/models.h"

namespace ajar {

namespace {

/// Constant radiance from all directions.
class ConstantEnvironment final : public Light {
 public:
  ConstantEnvironment(const Spectrum& radiance, const BoundingSphere& bounds)
      : radiance_(radiance), disk_(bounds) {}

  bool at_infinity() const override { return true; }
  bool discrete_position() const override { return false; }
  Spectrum power() const override { return radiance_ * (4.F * kPi * disk_.area()); }

  std::optional<EmissionSample> sample_emission(const EmissionUniforms& u) const override {
    if (radiance_.is_black()) return std::nullopt;
    const Vec3 toward = warp::uniform_sphere(u.direction);
    return EmissionSample{EndpointPoint::at_infinity(toward),
                          disk_.sample(toward, u.position),
                          -toward,
                          radiance_ * (4.F * kPi * disk_.area()),
                          Pdf<VertexMeasure>(warp::kUniformSpherePdf),
                          disk_.pdf()};
  }
  EmissionPdf emission_pdf(const EndpointPoint& /*point*/, const Vec3& /*w*/) const override {
    return {Pdf<VertexMeasure>(warp::kUniformSpherePdf), disk_.pdf()};
  }
  Spectrum emitted(const EndpointPoint& /*point*/, const Vec3& /*w*/) const override {
    return radiance_;
  }
  std::optional<ConnectionSample> sample_connection(const Vec3& /*reference*/,
                                                    const ConnectionUniforms& u) const override {
    if (radiance_.is_black()) return std::nullopt;
    const Vec3 toward = warp::uniform_sphere(u.position);
    return ConnectionSample{EndpointPoint::at_infinity(toward), toward,
                            std::numeric_limits<float>::infinity(), radiance_ * (4.F * kPi),
                            Pdf<VertexMeasure>(warp::kUniformSpherePdf)};
  }
  Pdf<VertexMeasure> connection_pdf(const Vec3& /*reference*/,
                                    const EndpointPoint& /*point*/) const override {
    return Pdf<VertexMeasure>(warp::kUniformSpherePdf);
  }
  std::optional<EmissionUniforms> invert_emission(const EndpointPoint& point, const Vec3& through,
                                                  const Vec3& /*w*/,
                                                  const EmissionUniforms& fresh) const override {
    const std::optional<Vec2> position = disk_.invert(point.toward, through);
    if (!position) return std::nullopt;
    return EmissionUniforms{fresh.primitive, *position, warp::uniform_sphere_inverse(point.toward)};
  }
  std::optional<ConnectionUniforms> invert_connection(
      const Vec3& /*reference*/, const EndpointPoint& point,
      const ConnectionUniforms& fresh) const override {
    return ConnectionUniforms{fresh.primitive, warp::uniform_sphere_inverse(point.toward)};
  }

 private:
  Spectrum radiance_;
  BoundingDisk disk_;
};

}  // namespace

std::unique_ptr<Light> make_constant_environment(const Spectrum& radiance,
                                                 const BoundingSphere& bounds) {
  return std::make_unique<ConstantEnvironment>(radiance, bounds);
}

}  // namespace ajar
