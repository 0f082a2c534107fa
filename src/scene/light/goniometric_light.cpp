#include <utility>

#include "scene/light/models.h"
#include "scene/light/point_connection.h"
#include "scene/light/sphere_map.h"

namespace ajar {

namespace {

/// A point light whose intensity is given by a map over directions, with θ from +y and φ from +x
/// toward +z. Source: pbrt-v3, section 12.3.3. Emission is sampled by the map.
class GoniometricLight final : public Light {
 public:
  GoniometricLight(const Spectrum& intensity, SphereMap map, const LightPlacement& at)
      : intensity_(intensity), map_(std::move(map)), at_(at) {}

  bool at_infinity() const override { return false; }
  bool discrete_position() const override { return true; }
  EndpointPoint only_point() const override { return EndpointPoint::at(at_.position); }
  Spectrum power() const override { return intensity_ * map_.integral(); }
  std::optional<LightBounds> bounds() const override {
    return point_bounds(at_.position, luminance(power()) * (0.25F * kInvPi));
  }

  std::optional<EmissionSample> sample_emission(const EmissionUniforms& u) const override {
    const SphereMap::Sample chosen = map_.sample(u.direction);
    const Spectrum intensity = intensity_ * map_.lookup(chosen.uv);
    if (intensity.is_black()) return std::nullopt;
    const Vec3 w = at_.directions.to_world(swap_axes(chosen.w));
    const float pdf = chosen.pdf.value() * at_.directions.to_local(w).stretch;
    if (!(pdf > 0.F)) return std::nullopt;
    return EmissionSample{EndpointPoint::at(at_.position), at_.position,       w, intensity / pdf,
                          Pdf<VertexMeasure>(1.F),         Pdf<Departure>(pdf)};
  }
  EmissionPdf emission_pdf(const EndpointPoint& /*point*/, const Vec3& w) const override {
    const DirectionMap::Local local = at_.directions.to_local(w);
    return {Pdf<VertexMeasure>(1.F),
            Pdf<Departure>(map_.pdf(map_uv(local.w)).value() * local.stretch)};
  }
  Spectrum emitted(const EndpointPoint& /*point*/, const Vec3& w) const override {
    return intensity_ * map_.lookup(map_uv(at_.directions.vector_to_local(w)));
  }
  std::optional<ConnectionSample> sample_connection(
      const Vec3& reference, const ConnectionUniforms& /*u*/) const override {
    return connect_to_point(at_.position, reference, [&](const Vec3& w) {
      return intensity_ * map_.lookup(map_uv(at_.directions.vector_to_local(w)));
    });
  }
  Pdf<VertexMeasure> connection_pdf(const Vec3& /*reference*/,
                                    const EndpointPoint& /*point*/) const override {
    return Pdf<VertexMeasure>(1.F);
  }
  std::optional<EmissionUniforms> invert_emission(const EndpointPoint& /*point*/,
                                                  const Vec3& /*through*/, const Vec3& w,
                                                  const EmissionUniforms& fresh) const override {
    const Vec2 uv = map_uv(at_.directions.to_local(w).w);
    if (!(map_.pdf(uv).value() > 0.F)) return std::nullopt;
    return EmissionUniforms{fresh.primitive, fresh.position, map_.invert(uv)};
  }
  std::optional<ConnectionUniforms> invert_connection(
      const Vec3& /*reference*/, const EndpointPoint& /*point*/,
      const ConnectionUniforms& fresh) const override {
    return fresh;
  }

 private:
  static Vec3 swap_axes(const Vec3& w) { return {w.x, w.z, w.y}; }
  Vec2 map_uv(const Vec3& local) const { return map_.to_uv(swap_axes(local)); }

  Spectrum intensity_;
  SphereMap map_;
  LightPlacement at_;
};

std::unique_ptr<Light> make_goniometric(const LightInputs& in) {
  const Spectrum intensity = in.color("intensity");
  std::optional<SphereMap> map = in.sphere_map({.gray = in.node().flag("gray")});
  if (!map) return make_point_light(intensity * in.scale_to("power", 4.F * kPi), in.at(), in.aim());
  const float scale = in.scale_to("power", luminance(map->integral()));
  return std::make_unique<GoniometricLight>(intensity * scale, std::move(*map), in.at());
}

}  // namespace

LightModel goniometric_light() {
  return {{.name = "goniometric",
           .summary = "from one point, by an image of all directions",
           .source = "Pharr et al. 2016, section 12.3.3",
           .parameters = {declare::emission("intensity", "W/sr", "factor of the image"),
                          declare::file("image", "all directions, with the pole at y"),
                          declare::flag("gray", "take the mean of its colours"),
                          sphere_projection_input(),
                          declare::target("power", "W",
                                          "if given, the luminance of all that a light of "
                                          "intensity 1 is scaled to emit")}},
          make_goniometric};
}

}  // namespace ajar
