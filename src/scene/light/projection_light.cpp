#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/light/models.h"
#include "scene/light/point_connection.h"

namespace ajar {

namespace {

/// A slide projector along +z: the map spans the field of view, which belongs to its shorter side;
/// row 0 is at the −y edge, column 0 at −x. Source: pbrt-v3, section 12.3.2. Emission is sampled by
/// the map.
class ProjectionLight final : public Light {
 public:
  ProjectionLight(const LightInputs& in, Map map)
      : intensity_(in.color("intensity")),
        map_(std::move(map)),
        at_(in.at()),
        half_size_(half_size(in.node().number("fov"), map_)) {
    // Solid angle per area of the window, which lies at z = 1: cos³ θ.
    const auto cos_cubed = [&](const Vec2& uv) {
      const float z = to_local(uv).z;
      return z * z * z;
    };
    distribution_ = make_map_distribution(map_, cos_cubed);
    const Spectrum integral = integrate_map(map_, cos_cubed) * window_area();
    intensity_ *= in.scale_to("power", luminance(integral));
    power_ = intensity_ * integral;
  }

  bool at_infinity() const override { return false; }
  bool discrete_position() const override { return true; }
  EndpointPoint only_point() const override { return EndpointPoint::at(at_.position); }
  Spectrum power() const override { return power_; }
  std::optional<LightBounds> bounds() const override {
    const Vec3 axis = at_.directions.to_world({0.F, 0.F, 1.F});
    float widest = 0.F;
    for (const Vec2& corner : {Vec2(0.F, 0.F), Vec2(1.F, 0.F), Vec2(0.F, 1.F), Vec2(1.F, 1.F)}) {
      widest = std::max(widest, angle_between(axis, at_.directions.to_world(to_local(corner))));
    }
    const Vec2& half = half_size_;
    const float solid_angle =
        4.F *
        std::asin(half.x * half.y / std::sqrt((1.F + half.x * half.x) * (1.F + half.y * half.y)));
    return LightBounds{Box3(at_.position),
                       {axis, std::min(widest + 1e-3F, kPi)},
                       0.F,
                       luminance(power_) / solid_angle,
                       false};
  }

  std::optional<EmissionSample> sample_emission(const EmissionUniforms& u) const override {
    const Distribution2D::Sample chosen = distribution_.sample(u.direction);
    const Spectrum intensity = intensity_ * map_.lookup(chosen.uv);
    if (intensity.is_black()) return std::nullopt;
    const Vec3 local = to_local(chosen.uv);
    const Vec3 w = at_.directions.to_world(local);
    const float pdf = density(chosen.pdf, local.z) * at_.directions.to_local(w).stretch;
    if (!(pdf > 0.F)) return std::nullopt;
    return EmissionSample{EndpointPoint::at(at_.position), at_.position,       w, intensity / pdf,
                          Pdf<VertexMeasure>(1.F),         Pdf<Departure>(pdf)};
  }
  EmissionPdf emission_pdf(const EndpointPoint& /*point*/, const Vec3& w) const override {
    const DirectionMap::Local local = at_.directions.to_local(w);
    const std::optional<Vec2> uv = to_uv(local.w);
    const float pdf = uv ? density(distribution_.pdf(*uv), local.w.z) * local.stretch : 0.F;
    return {Pdf<VertexMeasure>(1.F), Pdf<Departure>(pdf)};
  }
  Spectrum emitted(const EndpointPoint& /*point*/, const Vec3& w) const override {
    return intensity_towards(w);
  }
  std::optional<ConnectionSample> sample_connection(
      const Vec3& reference, const ConnectionUniforms& /*u*/) const override {
    return connect_to_point(at_.position, reference,
                            [&](const Vec3& w) { return intensity_towards(w); });
  }
  Pdf<VertexMeasure> connection_pdf(const Vec3& /*reference*/,
                                    const EndpointPoint& /*point*/) const override {
    return Pdf<VertexMeasure>(1.F);
  }
  std::optional<EmissionUniforms> invert_emission(const EndpointPoint& /*point*/,
                                                  const Vec3& /*through*/, const Vec3& w,
                                                  const EmissionUniforms& fresh) const override {
    const std::optional<Vec2> uv = to_uv(at_.directions.to_local(w).w);
    if (!uv || !(distribution_.pdf(*uv) > 0.F)) return std::nullopt;
    return EmissionUniforms{fresh.primitive, fresh.position, distribution_.invert(*uv)};
  }
  std::optional<ConnectionUniforms> invert_connection(
      const Vec3& /*reference*/, const EndpointPoint& /*point*/,
      const ConnectionUniforms& fresh) const override {
    return fresh;
  }

 private:
  static Vec2 half_size(float fov, const Map& map) {
    const float tangent = std::tan(std::clamp(fov, 1e-3F, 179.9F) * (kPi / 360.F));
    const float aspect = static_cast<float>(map.width()) / static_cast<float>(map.height());
    return Vec2(std::max(aspect, 1.F), std::max(1.F / aspect, 1.F)) * tangent;
  }
  float window_area() const { return 4.F * half_size_.x * half_size_.y; }
  float density(float pdf_uv, float cosine) const {
    return pdf_uv / (window_area() * cosine * cosine * cosine);
  }
  Vec3 to_local(const Vec2& uv) const {
    return normalize(
        Vec3((2.F * uv.x - 1.F) * half_size_.x, (2.F * uv.y - 1.F) * half_size_.y, 1.F));
  }
  /// Empty outside of the window.
  std::optional<Vec2> to_uv(const Vec3& local) const {
    if (!(local.z > 0.F)) return std::nullopt;
    const Vec2 p(local.x / (local.z * half_size_.x), local.y / (local.z * half_size_.y));
    if (!(std::abs(p.x) <= 1.F && std::abs(p.y) <= 1.F)) return std::nullopt;
    return Vec2(0.5F * p.x + 0.5F, 0.5F * p.y + 0.5F);
  }
  Spectrum intensity_towards(const Vec3& w) const {
    const std::optional<Vec2> uv = to_uv(at_.directions.vector_to_local(w));
    return uv ? intensity_ * map_.lookup(*uv) : Spectrum();
  }

  Spectrum intensity_;
  Map map_;
  LightPlacement at_;
  Vec2 half_size_;  ///< of the window at z = 1
  Distribution2D distribution_;
  Spectrum power_;
};

std::unique_ptr<Light> make_projection(const LightInputs& in) {
  std::optional<Map> map = in.map("image", MapEdge::Clamp);
  if (!map) map = Map(1, 1, {Spectrum(1.F)}, MapEdge::Clamp);
  return std::make_unique<ProjectionLight>(in, std::move(*map));
}

}  // namespace

LightModel projection_light() {
  return {{.name = "projection",
           .summary = "a slide projector along z",
           .source = "Pharr et al. 2016, section 12.3.2",
           .parameters = {declare::emission("intensity", "W/sr", "factor of the image"),
                          declare::number_between("fov", "45", "degrees",
                                                  "field of view along the image's shorter side",
                                                  0.0, 180.0),
                          declare::file("image", "the slide; white, unless given"),
                          declare::target("power", "W",
                                          "if given, the luminance of all that a light of "
                                          "intensity 1 is scaled to emit")}},
          make_projection};
}

}  // namespace ajar
