#include "scene/material/inputs.h"

namespace ajar {
namespace {

float mix(float a, float b, float t) { return a + (b - a) * t; }
float square(float x) { return x * x; }

/// Facets whose roughness is `roughness`², stretched by `aspect`.
Microfacets stretched_facets(FacetModel model, float roughness, float aspect) {
  const float alpha = roughness * roughness;
  return {model, alpha / aspect, alpha * aspect};
}

/// Disney's "principled" model. Sources: Burley 2012 and 2015, combined as Mitsuba 3 or pbrt-v3 do;
/// or in layers, as in appendix B of glTF 2.0. Transmissive materials have an inside, where they
/// are mere glass, as in Mitsuba: pbrt's has diffuse light there beside total reflection, which
/// grows without bound. Others are the same from both sides.
class Principled final : public Material {
 public:
  explicit Principled(const MaterialInputs& in);
  void add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const override;
  int max_lobes() const override;

 private:
  enum class Blend : std::uint8_t { Once, Twice, Layered };
  static Blend blend_of(const std::string& name) {
    return name == "layered" ? Blend::Layered : name == "twice" ? Blend::Twice : Blend::Once;
  }
  /// Data of a point that precede its lobes.
  struct Point {
    const SurfacePoint& at;
    Spectrum color;
    Spectrum tint;  ///< hue and saturation of the colour alone
    float metallic, transmission, eta, roughness, aspect;
    float behind;  ///< share of the diffuse light that leaves on the other side

    float opaque_dielectric() const { return (1.F - metallic) * (1.F - transmission); }
    Microfacets facets() const {
      return stretched_facets(FacetModel::GgxSeparable, roughness, aspect);
    }
  };
  Point point(const SurfacePoint& at) const;
  /// Share that is glass.
  float glass(const Point& p) const {
    return is_twice() ? p.transmission : p.transmission * (1.F - p.metallic);
  }
  Spectrum sheen(const Point& p) const;
  DisneyFresnel fresnel(const Point& p) const;
  void add_layers(const Point& p, const Spectrum& scale, Bsdf& bsdf) const;
  void add_diffuse(const Point& p, const Spectrum& scale, Bsdf& bsdf) const;
  void add_transmission(const Point& p, const Spectrum& scale, Bsdf& bsdf) const;

  bool is_twice() const { return blend_ == Blend::Twice; }
  /// A sheet of which a share is clear and glossy, without bending, and the rest is diffuse.
  bool is_split() const { return thin_ && blend_ == Blend::Once; }

  TextureSlot color_, metallic_, eta_, roughness_, specular_strength_, specular_tint_, anisotropic_,
      sheen_, sheen_tint_, clearcoat_, clearcoat_gloss_, coat_, coat_roughness_, spec_trans_,
      flatness_, diff_trans_;
  Blend blend_;
  bool thin_;
  bool has_inside_;
};

Principled::Principled(const MaterialInputs& in)
    : color_(in.slot("base_color")),
      metallic_(in.slot("metallic")),
      eta_(in.slot("eta")),
      roughness_(in.slot("roughness")),
      specular_strength_(in.slot("specular_strength")),
      specular_tint_(in.slot("specular_tint")),
      anisotropic_(in.slot("anisotropic")),
      sheen_(in.slot("sheen")),
      sheen_tint_(in.slot("sheen_tint")),
      clearcoat_(in.slot("clearcoat")),
      clearcoat_gloss_(in.slot("clearcoat_gloss")),
      coat_(in.slot("coat")),
      coat_roughness_(in.slot("coat_roughness")),
      spec_trans_(in.slot("specular_transmission")),
      flatness_(in.slot("flatness")),
      diff_trans_(in.slot("diffuse_transmission")),
      blend_(blend_of(in.node().text("blend"))),
      thin_(in.node().flag("thin")),
      has_inside_(!thin_ && blend_ != Blend::Layered && !spec_trans_.is_black()) {
  needs_tangent = !anisotropic_.is_black();
}

Principled::Point Principled::point(const SurfacePoint& at) const {
  const Spectrum color = reflectance(color_, at);
  const float brightness = luminance(color);
  return {.at = at,
          .color = color,
          .tint = brightness > 0.F ? color / brightness : Spectrum(1.F),
          .metallic = weight(metallic_, at),
          .transmission = weight(spec_trans_, at),
          .eta = index_of_refraction(eta_, at),
          .roughness = weight(roughness_, at),
          .aspect = std::sqrt(1.F - 0.9F * weight(anisotropic_, at)),
          .behind = thin_ ? within(0.5F * diff_trans_.eval_float(at), 0.F, 1.F) : 0.F};
}

void Principled::add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const {
  const Point p = point(at);
  if (blend_ == Blend::Layered) {
    add_layers(p, scale, bsdf);
    return;
  }
  add_diffuse(p, scale, bsdf);
  if (has_inside_) {
    bsdf.add(DisneyGlassSpecular{p.facets(), {fresnel(p), glass(p)}}, scale);
  } else {
    bsdf.add(DisneySpecular{p.facets(), fresnel(p)}, is_split() ? scale * p.transmission : scale);
  }
  const float clearcoat = weight(clearcoat_, at);
  if (clearcoat > 0.F) {
    const float alpha = mix(0.1F, 0.001F, weight(clearcoat_gloss_, at));
    bsdf.add(DisneyClearcoat{alpha, has_inside_, !is_twice()}, scale * clearcoat);
  }
  if (p.transmission > 0.F) add_transmission(p, scale, bsdf);
  if (thin_) {
    bsdf.add(LambertTransmission{}, scale * p.color * (p.behind * p.opaque_dielectric()));
  }
}

/// Varnish, gloss and base, each of which gets the rest of the light of those above it.
void Principled::add_layers(const Point& p, const Spectrum& scale, Bsdf& bsdf) const {
  const float share = weight(coat_, p.at);
  // Source of the limit: Pharr et al. 2023, section 9.6.2.
  const float rough = square(weight(coat_roughness_, p.at));
  const float alpha = rough < 1e-3F ? 0.F : rough;
  if (alpha > 0.F) {
    bsdf.add(RoughCoat{{FacetModel::Ggx, alpha, alpha}, {kVarnishIndex}}, scale * share);
  } else {
    bsdf.add(SmoothCoat{{kVarnishIndex}}, scale * share);
  }
  const Varnish varnish{alpha, share};
  bsdf.add(CoatAttenuated<DisneySpecular>{{p.facets(), fresnel(p)}, varnish}, scale);

  const Gloss gloss{p.eta, square(p.roughness), weight(specular_strength_, p.at)};
  const Spectrum base = scale * (1.F - p.metallic);
  const SheenOverLambert reflected(p.color * (1.F - p.behind), sheen(p));
  bsdf.add(CoatAttenuated<UnderGloss<SheenOverLambert>>{{reflected, gloss}, varnish}, base);
  bsdf.add(CoatAttenuated<UnderGloss<LambertTransmission>>{{{}, gloss}, varnish},
           base * p.color * p.behind);
}

void Principled::add_transmission(const Point& p, const Spectrum& scale, Bsdf& bsdf) const {
  // Thin sheets blur less than a solid of that roughness (Burley 2015, figure 15).
  const float thin_roughness = (0.65F * p.eta - 0.35F) * p.roughness;
  if (is_split()) {
    const Microfacets facets = stretched_facets(FacetModel::GgxSeparable, thin_roughness, p.aspect);
    bsdf.add(SheetTransmission{facets, p.eta}, scale * p.color * glass(p));
    return;
  }
  // The square root, so that light that enters and leaves has the colour once.
  const Spectrum through = sqrt(p.color) * glass(p);
  if (index_matched(p.eta)) {
    bsdf.add(SpecularTransmission{p.eta}, scale * through);
    return;
  }
  const Microfacets facets =
      thin_ ? stretched_facets(FacetModel::Ggx, thin_roughness, p.aspect) : p.facets();
  bsdf.add(RoughDielectric{facets, PackedSpectrum(), PackedSpectrum(through), p.eta}, scale);
}

/// A dielectric and a metal, which have their shares of the surface. The tinted share of the
/// dielectric follows Schlick's formula, as the metal does. pbrt-v3 takes the same of a colour that
/// is a blend of both already.
DisneyFresnel Principled::fresnel(const Point& p) const {
  const float dielectric_r0 = square((p.eta - 1.F) / (p.eta + 1.F));
  const float tinted = weight(specular_tint_, p.at);
  const float share = (1.F - p.metallic) * weight(specular_strength_, p.at);
  if (is_twice()) {
    const Spectrum white_r0 = dielectric_r0 * (Spectrum(1.F) + (p.tint - Spectrum(1.F)) * tinted);
    return {PackedSpectrum(white_r0 * share + p.color * p.metallic), p.metallic, p.eta, share};
  }
  const float tinted_share = share * tinted;
  const float by_schlick = p.metallic + tinted_share;
  if (!(by_schlick > 0.F)) return {PackedSpectrum(), 0.F, p.eta, share};
  const Spectrum r0 = (p.color * p.metallic + p.tint * (dielectric_r0 * tinted_share)) / by_schlick;
  return {PackedSpectrum(r0), by_schlick, p.eta, share - tinted_share};
}

Spectrum Principled::sheen(const Point& p) const {
  const float tint = weight(sheen_tint_, p.at);
  return (Spectrum(1.F) + (p.tint - Spectrum(1.F)) * tint) * weight(sheen_, p.at);
}

void Principled::add_diffuse(const Point& p, const Spectrum& scale, Bsdf& bsdf) const {
  const float opaque = 1.F - p.transmission;
  const float flatness = thin_ || !is_twice() ? weight(flatness_, p.at) : 0.F;
  const float ahead = 1.F - p.behind;
  DisneyDiffuse::Shares shares{(1.F - flatness) * ahead, flatness * ahead, 1.F};
  if (!is_twice()) shares.retro = shares.plain;
  float share_of_sheen = 1.F;
  if (is_split()) share_of_sheen = opaque * ahead;
  if (is_twice()) share_of_sheen = opaque;
  const Spectrum its_sheen = sheen(p) * share_of_sheen;
  if ((opaque == 0.F || p.color.is_black()) && its_sheen.is_black()) return;
  const DisneyDiffuse lobe{PackedSpectrum(p.color * opaque), PackedSpectrum(its_sheen), shares,
                           p.roughness, has_inside_};
  bsdf.add(lobe, scale * (1.F - p.metallic));
}

int Principled::max_lobes() const {
  const int sheet = thin_ ? 1 : 0;
  if (blend_ == Blend::Layered) return 2 + (coat_.is_black() ? 0 : 1) + sheet;
  return 2 + (clearcoat_.is_black() ? 0 : 1) + (spec_trans_.is_black() ? 0 : 1) + sheet;
}

ParameterSpec layered(std::string name, std::string help) {
  return declare::only_for("blend", {"layered"},
                           declare::textured_number(std::move(name), "0", std::move(help), 1.0));
}
ParameterSpec not_layered(std::string name, std::string value, std::string help) {
  return declare::only_for(
      "blend", {"once", "twice"},
      declare::textured_number(std::move(name), std::move(value), std::move(help), 1.0));
}

}  // namespace

MaterialModel principled_material() {
  return {
      {.name = "principled",
       .summary = "Disney's principled material",
       .source = "Burley 2012 and 2015",
       .parameters =
           {declare::reflectance("base_color", "0.5", "colour of the surface"),
            choice_parameter(
                "blend", {"once", "twice", "layered"},
                "shares of metal and dielectric: once, where a share of a thin sheet, "
                "specular_transmission, is clear and glossy, without bending, and the rest is "
                "diffuse; or twice, for the metal's colour, where flatness is for thin sheets only "
                "and spares retro-reflection, sheen is on what is opaque, metal refracts, all of a "
                "sheet is glossy, and the clearcoat is Burley's, not the flat one of Mitsuba 3; or "
                "in layers that take their light from those below, with "
                "an even base"),
            declare::textured_number("metallic", "0", "from dielectric to metal", 1.0),
            index_input(),
            declare::textured_number("roughness", "0.5", "root of the facets' alpha", 1.0),
            declare::textured_number("specular_strength", "1",
                                     "factor of the gloss of the dielectric, at all angles", 1.0),
            declare::textured_number("specular_tint", "0", "share of the base colour in the gloss",
                                     1.0),
            declare::textured_number("anisotropic", "0", "how much longer along u the gloss is",
                                     1.0),
            declare::textured_number("sheen", "0", "light that cloth reflects at grazing angles",
                                     1.0),
            declare::textured_number("sheen_tint", "0.5", "share of the base colour in the sheen",
                                     1.0),
            not_layered("clearcoat", "0", "a second gloss above all"),
            not_layered("clearcoat_gloss", "1", "how smooth the clearcoat is"),
            layered("coat", "share that is under a varnish of index 1.5"),
            layered("coat_roughness", "root of the alpha of its facets"),
            not_layered("specular_transmission", "0", "share of light that is refracted"),
            not_layered("flatness", "0", "share of flat diffuse reflection"),
            declare::textured_number("diffuse_transmission", "1",
                                     "of thin ones: diffuse transmission; 2 is all of it", 2.0),
            declare::flag("thin", "a sheet without thickness")}},
      make<Principled>};
}

}  // namespace ajar
