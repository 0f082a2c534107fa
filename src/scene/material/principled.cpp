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

/// Disney's "principled" model. Sources: Burley 2012 and 2015, combined as Mitsuba 3 or pbrt-v3 do.
/// (From behind, where pbrt's Schlick term is 1 at any angle, ours is the same as from the front.)
class Principled final : public Material {
 public:
  explicit Principled(const MaterialInputs& in);
  void add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const override;
  int max_lobes() const override;

 private:
  /// The varnish, and how much of the surface has it.
  struct Varnish {
    float share = 0.F;
    float alpha = 0.F;

    template <typename Base>
    void add_below(const Base& base, const Spectrum& scale, Bsdf& bsdf) const {
      if (share > 0.F) {
        bsdf.add(UnderVarnish<Base>{base, alpha, share}, scale);
      } else {
        bsdf.add(base, scale);
      }
    }
  };
  Varnish add_varnish(const SurfacePoint& at, const Spectrum& scale, float most, Bsdf& bsdf) const;
  /// What is known of a point before its lobes are.
  struct Point {
    const SurfacePoint& at;
    Spectrum color;
    Spectrum tint;  ///< hue and saturation of the colour alone
    float metallic, transmission, eta, roughness, aspect;
    float behind;  ///< share of the diffuse light that leaves on the other side
  };
  Point point(const SurfacePoint& at) const;
  DisneyFresnel fresnel(const Point& p) const;
  void add_diffuse(const Point& p, const Spectrum& scale, const Varnish& varnish, Bsdf& bsdf) const;
  void add_transmission(const Point& p, const Spectrum& scale, Bsdf& bsdf) const;

  TextureSlot color_, metallic_, eta_, roughness_, specular_strength_, specular_tint_, anisotropic_,
      sheen_, sheen_tint_, clearcoat_, clearcoat_gloss_, coat_, coat_roughness_, spec_trans_,
      flatness_, diff_trans_;
  bool thin_;
  bool is_split_;  ///< thin, and either clear or diffuse
  bool colors_twice_;
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
      thin_(in.node().flag("thin")),
      is_split_(thin_ && in.node().text("sheet") == "split"),
      colors_twice_(in.node().text("blend") == "twice") {
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
  const Varnish varnish = add_varnish(at, scale, 1.F - p.transmission, bsdf);
  add_diffuse(p, scale, varnish, bsdf);

  const Microfacets facets = stretched_facets(FacetModel::GgxSeparable, p.roughness, p.aspect);
  if (is_split_) {
    bsdf.add(SheetSpecular{facets, {fresnel(p)}}, scale * p.transmission);
  } else {
    varnish.add_below(DisneySpecular{facets, fresnel(p)}, scale, bsdf);
  }

  const float clearcoat = weight(clearcoat_, at);
  if (clearcoat > 0.F) {
    const float alpha = mix(0.1F, 0.001F, weight(clearcoat_gloss_, at));
    bsdf.add(DisneyClearcoat{alpha, !colors_twice_}, scale * clearcoat);
  }
  if (p.transmission > 0.F) add_transmission(p, scale, bsdf);
  if (thin_) {
    // Metal and what is clear let no diffuse light through; all of a sheet does that is glossy and
    // blended twice.
    const bool is_whole = colors_twice_ && !is_split_;
    const float share = is_whole ? 1.F : (1.F - p.metallic) * (1.F - p.transmission);
    varnish.add_below(LambertTransmission{}, scale * p.color * (p.behind * share), bsdf);
  }
}

void Principled::add_transmission(const Point& p, const Spectrum& scale, Bsdf& bsdf) const {
  const float share = colors_twice_ ? p.transmission : p.transmission * (1.F - p.metallic);
  // Thin sheets blur less than a solid of that roughness (Burley 2015, figure 15).
  const float thin_roughness = (0.65F * p.eta - 0.35F) * p.roughness;
  if (is_split_) {
    const Microfacets facets = stretched_facets(FacetModel::GgxSeparable, thin_roughness, p.aspect);
    bsdf.add(SheetTransmission{facets, p.eta}, scale * p.color * share);
    return;
  }
  // The square root, so that light that enters and leaves has the colour once.
  const Spectrum through = sqrt(p.color) * share;
  if (index_matched(p.eta)) {
    bsdf.add(SpecularTransmission{p.eta}, scale * through);
    return;
  }
  const Microfacets facets =
      thin_ ? stretched_facets(FacetModel::Ggx, thin_roughness, p.aspect)
            : stretched_facets(FacetModel::GgxSeparable, p.roughness, p.aspect);
  bsdf.add(RoughDielectric{facets, PackedSpectrum(), PackedSpectrum(through), p.eta}, scale);
}

/// A dielectric and a metal, which have their shares of the surface. The tinted share of the
/// dielectric follows Schlick's formula, as the metal does. pbrt-v3 takes the same of a colour that
/// is a blend of both already.
DisneyFresnel Principled::fresnel(const Point& p) const {
  const float dielectric_r0 = square((p.eta - 1.F) / (p.eta + 1.F));
  const float tinted = weight(specular_tint_, p.at);
  const float share = (1.F - p.metallic) * weight(specular_strength_, p.at);
  if (colors_twice_) {
    const Spectrum white_r0 = dielectric_r0 * (Spectrum(1.F) + (p.tint - Spectrum(1.F)) * tinted);
    return {PackedSpectrum(white_r0 * share + p.color * p.metallic), p.metallic, p.eta, share};
  }
  const float tinted_share = share * tinted;
  const float by_schlick = p.metallic + tinted_share;
  if (!(by_schlick > 0.F)) return {PackedSpectrum(), 0.F, p.eta, share};
  const Spectrum r0 = (p.color * p.metallic + p.tint * (dielectric_r0 * tinted_share)) / by_schlick;
  return {PackedSpectrum(r0), by_schlick, p.eta, share - tinted_share};
}

Principled::Varnish Principled::add_varnish(const SurfacePoint& at, const Spectrum& scale,
                                            float most, Bsdf& bsdf) const {
  const float share = is_split_ ? 0.F : weight(coat_, at) * most;
  if (!(share > 0.F)) return {};
  const float alpha = square(weight(coat_roughness_, at));
  // Source of the limit: Pharr et al. 2023, section 9.6.2.
  if (alpha < 1e-3F) {
    bsdf.add(SmoothCoat{{kVarnishIndex}}, scale * share);
    return {share, 0.F};
  }
  bsdf.add(RoughCoat{{FacetModel::Ggx, alpha, alpha}, {kVarnishIndex}}, scale * share);
  return {share, alpha};
}

void Principled::add_diffuse(const Point& p, const Spectrum& scale, const Varnish& varnish,
                             Bsdf& bsdf) const {
  const float opaque = 1.F - p.transmission;
  const float sheen = weight(sheen_, p.at);
  const float sheen_tint = weight(sheen_tint_, p.at);
  const Spectrum sheen_color = (Spectrum(1.F) + (p.tint - Spectrum(1.F)) * sheen_tint) * sheen;
  const float flatness = thin_ || !colors_twice_ ? weight(flatness_, p.at) : 0.F;
  const float ahead = 1.F - p.behind;
  DisneyDiffuse::Shares shares{(1.F - flatness) * ahead, flatness * ahead, 1.F};
  if (!colors_twice_) shares.retro = shares.plain;
  float share_of_sheen = 1.F;
  if (is_split_) share_of_sheen = opaque * ahead;
  if (colors_twice_) share_of_sheen = opaque;
  const DisneyDiffuse lobe{PackedSpectrum(p.color * opaque),
                           PackedSpectrum(sheen_color * share_of_sheen), shares, p.roughness};
  if ((opaque == 0.F || p.color.is_black()) && (sheen == 0.F || share_of_sheen == 0.F)) return;
  varnish.add_below(lobe, scale * (1.F - p.metallic), bsdf);
}

int Principled::max_lobes() const {
  return 2 + (clearcoat_.is_black() ? 0 : 1) + (coat_.is_black() ? 0 : 1) +
         (spec_trans_.is_black() ? 0 : 1) + (thin_ ? 1 : 0);
}

}  // namespace

MaterialModel principled_material() {
  return {
      {.name = "principled",
       .summary = "Disney's principled material",
       .source = "Burley 2012 and 2015",
       .parameters =
           {declare::reflectance("base_color", "0.5", "colour of the surface"),
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
            declare::textured_number("clearcoat", "0", "a second gloss above all", 1.0),
            declare::textured_number("clearcoat_gloss", "1", "how smooth the clearcoat is", 1.0),
            declare::textured_number("coat", "0",
                                     "share that is under a varnish of index 1.5; glass and split "
                                     "sheets never are",
                                     1.0),
            declare::textured_number("coat_roughness", "0", "root of the alpha of its facets", 1.0),
            declare::textured_number("specular_transmission", "0",
                                     "share of light that is refracted", 1.0),
            declare::textured_number("flatness", "0", "share of flat diffuse reflection", 1.0),
            declare::textured_number("diffuse_transmission", "1",
                                     "of thin ones: diffuse transmission; 2 is all of it", 2.0),
            declare::flag("thin", "a sheet without thickness"),
            choice_parameter("sheet", {"glossy", "split"},
                             "of thin ones: gloss all over, over what is refracted; or a share, "
                             "specular_transmission, that is clear and glossy, without bending, "
                             "and a diffuse rest"),
            choice_parameter("blend", {"once", "twice"},
                             "shares of metal and dielectric: once; or twice, for the metal's "
                             "colour. Then flatness is for thin sheets only and spares "
                             "retro-reflection, sheen is on what is opaque, metal refracts, and "
                             "the clearcoat is Burley's, not the flat one of Mitsuba 3")}},
      make<Principled>};
}

}  // namespace ajar
