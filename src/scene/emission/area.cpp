#include <cmath>

#include "core/frame.h"
#include "core/warp.h"
#include "scene/emission/inputs.h"
#include "scene/light/aim.h"

namespace ajar {

namespace {

/// Diffuse emission from a surface on the side of its geometric normal, or from both.
class AreaLight final : public Light {
 public:
  AreaLight(const Spectrum& radiance, TextureSlot texture, bool two_sided,
            const SurfaceSampler& surface, const Aim& aim)
      : radiance_(radiance),
        texture_(texture),
        two_sided_(two_sided),
        surface_(surface),
        aim_(aim),
        power_(mean_radiance() * (kPi * surface.area() * (two_sided ? 2.F : 1.F))) {}

  bool at_infinity() const override { return false; }
  bool discrete_position() const override { return false; }
  Spectrum power() const override { return power_; }
  std::uint32_t primitives() const override { return surface_.primitives(); }
  std::optional<LightBounds> bounds() const override {
    const SurfaceExtent extent = surface_.extent();
    // Projected area over area, along the axis, if normals are spread evenly over their cone: 1 for
    // a plane, 1/4 for a sphere.
    const float cosine = std::cos(extent.normals.angle);
    const float projected = cosine > 0.F ? 0.5F * (1.F + cosine) : 0.5F / (1.F - cosine);
    const float sides = two_sided_ ? 2.F : 1.F;
    return LightBounds{extent.box, extent.normals, 0.5F * kPi,
                       luminance(power_) * (projected * kInvPi / sides), two_sided_};
  }

  std::optional<EmissionSample> sample_emission(const EmissionUniforms& u) const override {
    const SurfaceSample at = surface_.sample({u.primitive, u.position});
    const Vec3 w = aim_.sample(at.point.p, u.direction, [&](const Vec2& square) {
      return cosine_direction(at.point, square);
    });
    const Pdf<Departure> departure = departure_pdf(at.point, w);
    const Spectrum radiance = radiance_at(at.point);
    if (departure.value() == 0.F || at.pdf.value() == 0.F || radiance.is_black()) {
      return std::nullopt;
    }
    const Spectrum weight =
        radiance * (std::abs(dot(at.point.ng, w)) / departure.value() / at.pdf.value());
    return EmissionSample{{at.point, Vec3(0.F)},
                          at.point.p,
                          w,
                          weight,
                          Pdf<VertexMeasure>(at.pdf.value()),
                          departure};
  }

  EmissionPdf emission_pdf(const EndpointPoint& point, const Vec3& w) const override {
    return {Pdf<VertexMeasure>(surface_.pdf(point.surface).value()),
            departure_pdf(point.surface, w)};
  }

  Spectrum emitted(const EndpointPoint& point, const Vec3& w) const override {
    if (!two_sided_ && !(dot(point.surface.ng, w) > 0.F)) return Spectrum();
    return radiance_at(point.surface);
  }

  std::optional<ConnectionSample> sample_connection(const Vec3& reference,
                                                    const ConnectionUniforms& u) const override {
    const std::optional<SurfaceSample> at =
        surface_.sample_toward(reference, {u.primitive, u.position});
    if (!at || !(at->pdf.value() > 0.F)) return std::nullopt;
    const Vec3 d = at->point.p - reference;
    const float squared = length_squared(d);
    if (!(squared > 0.F)) return std::nullopt;
    const float distance = std::sqrt(squared);
    const Vec3 w = d / distance;
    const float cosine = -dot(at->point.ng, w);
    if (!(two_sided_ ? cosine != 0.F : cosine > 0.F)) return std::nullopt;
    const Spectrum weight =
        radiance_at(at->point) * (std::abs(cosine) / (squared * at->pdf.value()));
    if (weight.is_black() || !weight.is_finite()) return std::nullopt;
    // Filled in place, like all big samples: copying what was just written makes processors wait.
    std::optional<ConnectionSample> result(std::in_place);
    result->point.surface = at->point;
    result->point.toward = Vec3(0.F);
    result->w = w;
    result->distance = distance;
    result->weight = weight;
    result->pdf = Pdf<VertexMeasure>(at->pdf.value());
    return result;
  }

  Pdf<VertexMeasure> connection_pdf(const Vec3& reference,
                                    const EndpointPoint& point) const override {
    return Pdf<VertexMeasure>(surface_.pdf_toward(reference, point.surface).value());
  }
  std::optional<EmissionUniforms> invert_emission(const EndpointPoint& point,
                                                  const Vec3& /*through*/, const Vec3& w,
                                                  const EmissionUniforms& fresh) const override {
    const auto at = surface_.invert(point.surface, {fresh.primitive, fresh.position});
    const Pdf<Departure> own = cosine_pdf(point.surface, w);
    if (!at || own.value() == 0.F) return std::nullopt;
    const Vec3 local = Frame::around(point.surface.ng).to_local(w);
    Vec2 square = warp::uniform_disk_inverse({local.x, local.y});
    if (two_sided_) square.x = 0.5F * square.x + (local.z < 0.F ? 0.5F : 0.F);
    return EmissionUniforms{at->primitive, at->position,
                            aim_.invert(point.surface.p, w, own, square, fresh.direction.x)};
  }
  std::optional<ConnectionUniforms> invert_connection(
      const Vec3& reference, const EndpointPoint& point,
      const ConnectionUniforms& fresh) const override {
    const auto at =
        surface_.invert_toward(reference, point.surface, {fresh.primitive, fresh.position});
    if (!at) return std::nullopt;
    return ConnectionUniforms{at->primitive, at->position};
  }

 private:
  Spectrum radiance_at(const SurfacePoint& at) const { return radiance_ * texture_.eval(at); }

  Pdf<Departure> departure_pdf(const SurfacePoint& at, const Vec3& w) const {
    const Pdf<Departure> own = cosine_pdf(at, w);
    // Aimed directions that the surface does not shine in carry nothing.
    return own.value() == 0.F ? own : aim_.pdf(at.p, w, own);
  }
  Vec3 cosine_direction(const SurfacePoint& at, Vec2 square) const {
    float side = 1.F;
    if (two_sided_) {
      const bool back = square.x >= 0.5F;
      square.x = std::min(2.F * square.x - (back ? 1.F : 0.F), kOneMinusEpsilon);
      side = back ? -1.F : 1.F;
    }
    const Vec3 local = warp::cosine_hemisphere(square);
    return Frame::around(at.ng).to_world({local.x, local.y, side * local.z});
  }
  Pdf<Departure> cosine_pdf(const SurfacePoint& at, const Vec3& w) const {
    const float cosine = dot(at.ng, w);
    if (two_sided_) return Pdf<Departure>(std::abs(cosine) * (0.5F * kInvPi));
    return Pdf<Departure>(warp::cosine_hemisphere_pdf(cosine));
  }

  /// Average of a texture over points spread evenly on the surface. A texture may be bright only
  /// between them, so a little is left of the untextured radiance in any case.
  Spectrum mean_radiance() const {
    if (texture_.is_constant()) return radiance_ * texture_.eval(SurfacePoint{});
    constexpr int kPoints = 64;
    Spectrum sum;
    for (int i = 0; i < kPoints; ++i) {
      // Kronecker sequence of the plastic number's powers, in three dimensions (M. Roberts 2018).
      const auto fraction = [i](double step) {
        const double x = (i + 0.5) * step;
        return std::min(static_cast<float>(x - std::floor(x)), kOneMinusEpsilon);
      };
      sum += radiance_at(surface_
                             .sample({fraction(0.8191725133961645),
                                      {fraction(0.6710436067037893), fraction(0.5497004779019703)}})
                             .point);
    }
    constexpr float kLeast = 1e-3F;
    return sum / static_cast<float>(kPoints) + radiance_ * kLeast;
  }

  Spectrum radiance_;
  TextureSlot texture_;
  bool two_sided_;
  const SurfaceSampler& surface_;
  Aim aim_;
  Spectrum power_;
};

std::unique_ptr<Light> make_area_light(const EmissionInputs& in) {
  const desc::Value& radiance = in.node().get("radiance");
  const bool is_textured = std::holds_alternative<desc::TextureRef>(radiance);
  // A texture stays as it is, a colour and the scale become one.
  const desc::Rgb color =
      (is_textured ? desc::Rgb(1.F) : std::get<Vec3>(radiance)) * in.node().color("scale");
  if (!is_finite(color)) {
    throw SceneError(in.where(), "the light is too strong: it is not a finite number");
  }
  const TextureSlot texture = is_textured ? in.slot("radiance") : TextureSlot(Spectrum(1.F));
  return std::make_unique<AreaLight>(rgb_spectrum(color), texture, in.node().flag("two_sided"),
                                     in.surface(), Aim(in.receivers()));
}

}  // namespace

EmissionModel area_emission() {
  return {
      {.name = "area",
       .summary = "the same radiance in all directions from every point of a surface",
       .source = "",
       .parameters = {declare::textured_emission("radiance", "W/(m2 sr)",
                                                 "radiance of the surface"),
                      declare::emission("scale", "", "multiplies the radiance"),
                      declare::flag("two_sided", "from both sides, not only that of the normal")}},
      make_area_light};
}

}  // namespace ajar
