#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/light/models.h"
#include "scene/light/point_connection.h"

namespace ajar {

namespace {

/// A slide projector along +z: the map spans the field of view, row 0 is at the −y edge, column 0
/// at −x. It is of the intensity, or of the irradiance at z = 1, 1/cos³ θ times as much. Source:
/// pbrt-v3, section 12.3.2. Emission is sampled by the map.
class ProjectionLight final : public Light {
 public:
  ProjectionLight(const LightInputs& in, Map map)
      : intensity_(in.color("intensity")),
        map_(std::move(map)),
        at_(in.at()),
        axis_(at_.directions.to_world({0.F, 0.F, 1.F})),
        is_of_irradiance_(in.node().text("image_is") == "irradiance"),
        half_size_(half_size(in.node(), map_)) {
    // Solid angle per area of the window, which lies at z = 1: cos³ θ.
    const auto weight = [&](const Vec2& uv) {
      const float z = to_local(uv).z;
      return is_of_irradiance_ ? 1.F : z * z * z;
    };
    distribution_ = make_map_distribution(map_, weight);
    const Spectrum integral = integrate_map(map_, weight) * window_area();
    intensity_ *= in.scale_to("power", luminance(integral));
    power_ = intensity_ * integral;
  }

  bool at_infinity() const override { return false; }
  bool discrete_position() const override { return true; }
  EndpointPoint only_point() const override { return EndpointPoint::at(at_.position); }
  Spectrum power() const override { return power_; }
  std::optional<LightBounds> bounds() const override {
    float widest = 0.F;
    for (const Vec2& corner : {Vec2(0.F, 0.F), Vec2(1.F, 0.F), Vec2(0.F, 1.F), Vec2(1.F, 1.F)}) {
      widest = std::max(widest, angle_between(axis_, at_.directions.to_world(to_local(corner))));
    }
    const Vec2& half = half_size_;
    const float solid_angle =
        4.F *
        std::asin(half.x * half.y / std::sqrt((1.F + half.x * half.x) * (1.F + half.y * half.y)));
    return LightBounds{Box3(at_.position),
                       {axis_, std::min(widest + 1e-3F, kPi)},
                       0.F,
                       luminance(power_) / solid_angle,
                       false};
  }

  std::optional<EmissionSample> sample_emission(const EmissionUniforms& u) const override {
    const Distribution2D::Sample chosen = distribution_.sample(u.direction);
    const Vec3 local = to_local(chosen.uv);
    const Vec3 w = at_.directions.to_world(local);
    const Spectrum intensity = intensity_at(chosen.uv, w);
    if (intensity.is_black()) return std::nullopt;
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
  static Vec2 half_size(const desc::Node& node, const Map& map) {
    const std::string& axis = node.text("fov_axis");
    const float aspect = static_cast<float>(map.width()) / static_cast<float>(map.height());
    // With the side that the field of view belongs to as 1.
    Vec2 size(std::max(aspect, 1.F), std::max(1.F / aspect, 1.F));
    if (axis == "x" || (axis == "longer" && aspect > 1.F)) size /= size.x;
    if (axis == "y" || (axis == "longer" && aspect <= 1.F)) size /= size.y;
    if (axis == "diagonal") size /= size.length();
    return size * std::tan(std::clamp(node.number("fov"), 1e-3F, 179.9F) * (kPi / 360.F));
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
    return uv ? intensity_at(*uv, w) : Spectrum();
  }
  /// Intensity in the direction `w` (world), which goes through the window at `uv`.
  Spectrum intensity_at(const Vec2& uv, const Vec3& w) const {
    const Spectrum intensity = intensity_ * map_.lookup(uv);
    if (!is_of_irradiance_) return intensity;
    const float cosine = dot(axis_, w);
    return intensity / (cosine * cosine * cosine);
  }

  Spectrum intensity_;
  Map map_;
  LightPlacement at_;
  Vec3 axis_;  ///< in the world
  bool is_of_irradiance_;
  Vec2 half_size_;  ///< half the size of the window at z = 1
  Distribution2D distribution_;
  Spectrum power_;
};

std::unique_ptr<Light> make_projection(const LightInputs& in) {
  std::optional<Map> map =
      in.map("image", MapEdge::Clamp, MapFilter::Bilinear, in.decoding_exponent());
  if (!map) map = Map(1, 1, {Spectrum(1.F)}, MapEdge::Clamp);
  return std::make_unique<ProjectionLight>(in, std::move(*map));
}

}  // namespace

LightModel projection_light() {
  return {
      {.name = "projection",
       .summary = "a slide projector along z",
       .source = "Pharr et al. 2016, section 12.3.2",
       .parameters = {declare::emission("intensity", "W/sr", "factor of the image"),
                      declare::number_between("fov", "45", "degrees", "field of view", 0.0, 180.0),
                      choice_parameter("fov_axis", {"shorter", "longer", "x", "y", "diagonal"},
                                       "side of the image that `fov` belongs to"),
                      declare::file("image", "the slide; white, unless given"),
                      choice_parameter("image_is", {"intensity", "irradiance"},
                                       "the intensity, or the irradiance of a plane at z = 1"),
                      declare::decoding(),
                      declare::target("power", "W",
                                      "if given, the luminance of all that a light of "
                                      "intensity 1 is scaled to emit")}},
      make_projection};
}

}  // namespace ajar
