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
  DisneyFresnel fresnel(const SurfacePoint& at, const Spectrum& color, const Spectrum& tint,
                        float metallic, float eta) const;
  void add_diffuse(const SurfacePoint& at, const Spectrum& scale, const Spectrum& color,
                   const Spectrum& tint, float roughness, float share, const Varnish& varnish,
                   Bsdf& bsdf) const;

  TextureSlot color_, metallic_, eta_, roughness_, specular_strength_, specular_tint_, anisotropic_,
      sheen_, sheen_tint_, clearcoat_, clearcoat_gloss_, coat_, coat_roughness_, spec_trans_,
      flatness_, diff_trans_;
  bool thin_;
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
      colors_twice_(in.node().text("blend") == "twice") {
  needs_tangent = !anisotropic_.is_black();
}

void Principled::add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const {
  const Spectrum color = reflectance(color_, at);
  const float metallic = weight(metallic_, at);
  const float transmission = weight(spec_trans_, at);
  const float eta = index_of_refraction(eta_, at);
  const float roughness = weight(roughness_, at);
  const float brightness = luminance(color);
  // Hue and saturation alone.
  const Spectrum tint = brightness > 0.F ? color / brightness : Spectrum(1.F);

  const Varnish varnish = add_varnish(at, scale, 1.F - transmission, bsdf);
  const float diffuse_share = (1.F - metallic) * (1.F - transmission);
  if (diffuse_share > 0.F) {
    add_diffuse(at, scale, color, tint, roughness, diffuse_share, varnish, bsdf);
  }

  const float aspect = std::sqrt(1.F - 0.9F * weight(anisotropic_, at));
  const Microfacets facets = stretched_facets(FacetModel::GgxSeparable, roughness, aspect);
  varnish.add_below(DisneySpecular{facets, fresnel(at, color, tint, metallic, eta)}, scale, bsdf);

  const float clearcoat = weight(clearcoat_, at);
  if (clearcoat > 0.F) {
    const float alpha = mix(0.1F, 0.001F, weight(clearcoat_gloss_, at));
    bsdf.add(DisneyClearcoat{alpha}, scale * clearcoat);
  }

  if (transmission > 0.F) {
    // The square root, so that light that enters and leaves has the colour once.
    const Spectrum through = sqrt(color) * transmission;
    if (index_matched(eta)) {
      bsdf.add(SpecularTransmission{eta}, scale * through);
    } else {
      // Thin sheets blur less than a solid of that roughness (Burley 2015, figure 15).
      const Microfacets thin_facets =
          stretched_facets(FacetModel::Ggx, (0.65F * eta - 0.35F) * roughness, aspect);
      bsdf.add(RoughDielectric{thin_ ? thin_facets : facets, PackedSpectrum(),
                               PackedSpectrum(through), eta},
               scale);
    }
  }
  if (thin_) {
    const float transmitted = within(0.5F * diff_trans_.eval_float(at), 0.F, 1.F);
    varnish.add_below(LambertTransmission{}, scale * color * transmitted, bsdf);
  }
}

/// A dielectric and a metal, which have their shares of the surface. The tinted share of the
/// dielectric follows Schlick's formula, as the metal does. pbrt-v3 takes the same of a colour that
/// is a blend of both already.
DisneyFresnel Principled::fresnel(const SurfacePoint& at, const Spectrum& color,
                                  const Spectrum& tint, float metallic, float eta) const {
  const float dielectric_r0 = square((eta - 1.F) / (eta + 1.F));
  const float tinted = weight(specular_tint_, at);
  const float strength = weight(specular_strength_, at);
  if (colors_twice_) {
    const Spectrum white_r0 = dielectric_r0 * (Spectrum(1.F) + (tint - Spectrum(1.F)) * tinted);
    return {PackedSpectrum(white_r0 * (strength * (1.F - metallic)) + color * metallic), metallic,
            eta, strength * (1.F - metallic)};
  }
  const float share = (1.F - metallic) * strength;
  const float tinted_share = share * tinted;
  const float by_schlick = metallic + tinted_share;
  if (!(by_schlick > 0.F)) return {PackedSpectrum(), 0.F, eta, share};
  const Spectrum r0 = (color * metallic + tint * (dielectric_r0 * tinted_share)) / by_schlick;
  return {PackedSpectrum(r0), by_schlick, eta, share - tinted_share};
}

Principled::Varnish Principled::add_varnish(const SurfacePoint& at, const Spectrum& scale,
                                            float most, Bsdf& bsdf) const {
  const float share = weight(coat_, at) * most;
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

void Principled::add_diffuse(const SurfacePoint& at, const Spectrum& scale, const Spectrum& color,
                             const Spectrum& tint, float roughness, float share,
                             const Varnish& varnish, Bsdf& bsdf) const {
  const float sheen = weight(sheen_, at);
  const float sheen_tint = weight(sheen_tint_, at);
  const Spectrum sheen_color = (Spectrum(1.F) + (tint - Spectrum(1.F)) * sheen_tint) * sheen;
  DisneyDiffuse lobe{PackedSpectrum(color), PackedSpectrum(sheen_color), 1.F, 0.F, roughness};
  if (thin_ || !colors_twice_) {
    const float reflected = thin_ ? 1.F - within(0.5F * diff_trans_.eval_float(at), 0.F, 1.F) : 1.F;
    const float flatness = weight(flatness_, at);
    lobe.diffuse = (1.F - flatness) * reflected;
    lobe.fake_subsurface = flatness * reflected;
  }
  if (color.is_black() && sheen == 0.F) return;
  varnish.add_below(lobe, scale * share, bsdf);
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
            declare::textured_number(
                "coat", "0", "share that is under a varnish of index 1.5; glass never is", 1.0),
            declare::textured_number("coat_roughness", "0", "root of the alpha of its facets", 1.0),
            declare::textured_number("specular_transmission", "0",
                                     "share of light that is refracted", 1.0),
            declare::textured_number("flatness", "0", "share of flat diffuse reflection", 1.0),
            declare::textured_number("diffuse_transmission", "1",
                                     "of thin ones: diffuse transmission; 2 is all of it", 2.0),
            declare::flag("thin", "a sheet without thickness"),
            choice_parameter("blend", {"once", "twice"},
                             "shares of metal and dielectric: once; or twice, for the metal's "
                             "colour, and flatness for thin sheets only")}},
      make<Principled>};
}

}  // namespace ajar
