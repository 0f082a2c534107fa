#include <limits>
#include <utility>

#include "scene/light/bounding_disk.h"
#include "scene/light/models.h"
#include "scene/light/sphere_map.h"

namespace ajar {

namespace {

/// Radiance from infinity by a map of all directions. The vertex keeps its place in the map in
/// `surface.uv`: cheaper than finding it again from the direction, and a sampled vertex stays in
/// the cell that it was sampled from, whatever the rounding. Source: pbrt-v3, sections 12.6
/// and 14.2.4.
class EnvironmentMap final : public Light {
 public:
  EnvironmentMap(const Spectrum& scale, SphereMap map, const DirectionMap& directions,
                 const BoundingSphere& bounds)
      : scale_(scale), map_(std::move(map)), directions_(directions), disk_(bounds) {}

  bool at_infinity() const override { return true; }
  bool discrete_position() const override { return false; }
  Spectrum power() const override { return scale_ * map_.integral() * disk_.area(); }

  EndpointPoint at_direction(const Vec3& w) const override {
    return EndpointPoint::at_infinity(w, map_.to_uv(directions_.vector_to_local(w)));
  }

  std::optional<EmissionSample> sample_emission(const EmissionUniforms& u) const override {
    const auto seen = sample_direction(u.direction);
    if (!seen) return std::nullopt;
    const Vec3& toward = seen->point.toward;
    return EmissionSample{seen->point, disk_.sample(toward, u.position),
                          -toward,     seen->weight * disk_.area(),
                          seen->pdf,   disk_.pdf()};
  }
  EmissionPdf emission_pdf(const EndpointPoint& point, const Vec3& /*w*/) const override {
    return {direction_pdf(point), disk_.pdf()};
  }
  Spectrum emitted(const EndpointPoint& point, const Vec3& /*w*/) const override {
    return scale_ * map_.lookup(point.surface.uv);
  }
  std::optional<ConnectionSample> sample_connection(const Vec3& /*reference*/,
                                                    const ConnectionUniforms& u) const override {
    return sample_direction(u.position);
  }
  Pdf<VertexMeasure> connection_pdf(const Vec3& /*reference*/,
                                    const EndpointPoint& point) const override {
    return direction_pdf(point);
  }
  std::optional<EmissionUniforms> invert_emission(const EndpointPoint& point, const Vec3& through,
                                                  const Vec3& /*w*/,
                                                  const EmissionUniforms& fresh) const override {
    const std::optional<Vec2> position = disk_.invert(point.toward, through);
    if (!position || !(direction_pdf(point).value() > 0.F)) return std::nullopt;
    return EmissionUniforms{fresh.primitive, *position, map_.invert(point.surface.uv)};
  }
  std::optional<ConnectionUniforms> invert_connection(
      const Vec3& /*reference*/, const EndpointPoint& point,
      const ConnectionUniforms& fresh) const override {
    if (!(direction_pdf(point).value() > 0.F)) return std::nullopt;
    return ConnectionUniforms{fresh.primitive, map_.invert(point.surface.uv)};
  }

 private:
  std::optional<ConnectionSample> sample_direction(const Vec2& u) const {
    const SphereMap::Sample chosen = map_.sample(u);
    const Spectrum radiance = scale_ * map_.lookup(chosen.uv);
    if (radiance.is_black()) return std::nullopt;
    const Vec3 toward = directions_.to_world(chosen.w);
    const float pdf = chosen.pdf.value() * directions_.to_local(toward).stretch;
    if (!(pdf > 0.F)) return std::nullopt;
    std::optional<ConnectionSample> result(std::in_place);
    result->point = EndpointPoint::at_infinity(toward, chosen.uv);
    result->w = toward;
    result->distance = std::numeric_limits<float>::infinity();
    result->weight = radiance / pdf;
    result->pdf = Pdf<VertexMeasure>(pdf);
    return result;
  }
  Pdf<VertexMeasure> direction_pdf(const EndpointPoint& point) const {
    return Pdf<VertexMeasure>(map_.pdf(point.surface.uv).value() *
                              directions_.to_local(point.toward).stretch);
  }

  Spectrum scale_;
  SphereMap map_;
  DirectionMap directions_;
  BoundingDisk disk_;
};

}  // namespace

std::unique_ptr<Light> make_environment_map(const Spectrum& scale, SphereMap map,
                                            const LightPlacement& at,
                                            const BoundingSphere& bounds) {
  return std::make_unique<EnvironmentMap>(scale, std::move(map), at.directions, bounds);
}

}  // namespace ajar
