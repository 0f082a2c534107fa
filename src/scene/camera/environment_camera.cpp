#include <algorithm>
#include <cmath>

#include "scene/camera/models.h"
#include "scene/camera/screen.h"

namespace ajar {

namespace {

/// Everything around one point: θ = π y / height from +y, φ = 2π x / width from +x toward +z of the
/// camera. The raster is uniform, so W_e = 1 / (2π² sin θ). Source: pbrt-v3, section 6.3.
class EnvironmentCamera final : public Camera {
 public:
  EnvironmentCamera(const desc::Camera& camera, Vec2i resolution)
      : Camera(resolution),
        directions_(camera.to_world),
        position_(transform_point(camera.to_world, Vec3(0.F))) {}

  bool at_infinity() const override { return false; }
  bool discrete_position() const override { return true; }
  Box3 bounds() const override { return Box3(position_); }

  std::optional<EmissionSample> sample_emission(const EmissionUniforms& u) const override {
    // The pole itself has no density; a ray next to it does.
    const float theta = kPi * std::max(u.direction.y, 1e-6F);
    const float phi = 2.F * kPi * u.direction.x;
    const float sine = std::sin(theta);
    const Vec3 w =
        directions_.to_world({sine * std::cos(phi), std::cos(theta), sine * std::sin(phi)});
    return EmissionSample{
        EndpointPoint::at(position_), position_, w, Spectrum(1.F), Pdf<VertexMeasure>(1.F),
        Pdf<Departure>(density(w))};
  }
  EmissionPdf emission_pdf(const EndpointPoint& /*point*/, const Vec3& w) const override {
    return {Pdf<VertexMeasure>(1.F), Pdf<Departure>(density(w))};
  }
  Spectrum emitted(const EndpointPoint& /*point*/, const Vec3& w) const override {
    return Spectrum(density(w));
  }
  std::optional<ConnectionSample> sample_connection(
      const Vec3& reference, const ConnectionUniforms& /*u*/) const override {
    const Vec3 d = position_ - reference;
    const float squared = length_squared(d);
    if (!(squared > 0.F)) return std::nullopt;
    const float distance = std::sqrt(squared);
    const Vec3 w = d / distance;
    const Spectrum weight(density(-w) / squared);
    if (!weight.is_finite()) return std::nullopt;
    return ConnectionSample{EndpointPoint::at(position_), w, distance, weight,
                            Pdf<VertexMeasure>(1.F)};
  }
  Pdf<VertexMeasure> connection_pdf(const Vec3& /*reference*/,
                                    const EndpointPoint& /*point*/) const override {
    return Pdf<VertexMeasure>(1.F);
  }
  std::optional<Vec2> raster(const EndpointPoint& /*point*/, const Vec3& w) const override {
    const Vec3 local = directions_.vector_to_local(w);
    const float theta = std::atan2(std::sqrt(local.x * local.x + local.z * local.z), local.y);
    float x = std::atan2(local.z, local.x) * (0.5F * kInvPi);
    if (x < 0.F) x += 1.F;
    return unit_to_raster({x, theta * kInvPi}, Vec2(resolution()));
  }

 private:
  float density(const Vec3& w) const {
    const DirectionMap::Local local = directions_.to_local(w);
    const float sine = std::sqrt(local.w.x * local.w.x + local.w.z * local.w.z);
    return local.stretch / (2.F * kPi * kPi * std::max(sine, 1e-7F));
  }

  DirectionMap directions_;
  Vec3 position_;
};

}  // namespace

std::unique_ptr<Camera> make_environment_camera(const desc::Camera& camera, Vec2i resolution) {
  return std::make_unique<EnvironmentCamera>(camera, resolution);
}

}  // namespace ajar
