#include "scene/material/disney.h"

namespace ajar {
namespace {
float mix(float a, float b, float t) { return a + (b - a) * t; }
float square(float x) { return x * x; }

/// Facets whose roughness is `roughness`², stretched by `aspect`.
Microfacets stretched_facets(FacetModel model, float roughness, float aspect) {
  const float alpha = roughness * roughness;
  return {model, alpha / aspect, alpha * aspect};
}
}  // namespace

Disney::Disney(const desc::DisneyMaterial& d, const Slots& slots)
    : color_(slots(d.color, 0.5F)),
      metallic_(slots(d.metallic, 0.F)),
      eta_(slots(d.eta, 1.5F)),
      roughness_(slots(d.roughness, 0.5F)),
      specular_tint_(slots(d.specular_tint, 0.F)),
      anisotropic_(slots(d.anisotropic, 0.F)),
      sheen_(slots(d.sheen, 0.F)),
      sheen_tint_(slots(d.sheen_tint, 0.5F)),
      clearcoat_(slots(d.clearcoat, 0.F)),
      clearcoat_gloss_(slots(d.clearcoat_gloss, 1.F)),
      spec_trans_(slots(d.spec_trans, 0.F)),
      flatness_(slots(d.flatness, 0.F)),
      diff_trans_(slots(d.diff_trans, 1.F)),
      thin_(d.thin) {
  needs_tangent = !anisotropic_.is_black();
}

void Disney::add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const {
  const Spectrum color = reflectance(color_, at);
  const float metallic = weight(metallic_, at);
  const float transmission = weight(spec_trans_, at);
  const float eta = index_of_refraction(eta_, at);
  const float roughness = weight(roughness_, at);
  const float brightness = luminance(color);
  // Hue and saturation alone.
  const Spectrum tint = brightness > 0.F ? color / brightness : Spectrum(1.F);

  const float diffuse_share = (1.F - metallic) * (1.F - transmission);
  if (diffuse_share > 0.F) {
    add_diffuse(at, scale, color, tint, roughness, diffuse_share, bsdf);
  }

  const float aspect = std::sqrt(1.F - 0.9F * weight(anisotropic_, at));
  const Microfacets facets = stretched_facets(FacetModel::GgxSeparable, roughness, aspect);
  const float dielectric_r0 = square((eta - 1.F) / (eta + 1.F));
  const float tinted = weight(specular_tint_, at);
  const Spectrum white_r0 = dielectric_r0 * (Spectrum(1.F) + (tint - Spectrum(1.F)) * tinted);
  const Spectrum r0 = white_r0 * (1.F - metallic) + color * metallic;
  bsdf.add(DisneySpecular{facets, {PackedSpectrum(r0), metallic, eta}}, scale);

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
    bsdf.add(LambertTransmission{}, scale * color * transmitted);
  }
}

void Disney::add_diffuse(const SurfacePoint& at, const Spectrum& scale, const Spectrum& color,
                         const Spectrum& tint, float roughness, float share, Bsdf& bsdf) const {
  const float sheen = weight(sheen_, at);
  const float sheen_tint = weight(sheen_tint_, at);
  const Spectrum sheen_color = (Spectrum(1.F) + (tint - Spectrum(1.F)) * sheen_tint) * sheen;
  DisneyDiffuse lobe{PackedSpectrum(color), PackedSpectrum(sheen_color), 1.F, 0.F, roughness};
  if (thin_) {
    const float reflected = 1.F - within(0.5F * diff_trans_.eval_float(at), 0.F, 1.F);
    const float flatness = weight(flatness_, at);
    lobe.diffuse = (1.F - flatness) * reflected;
    lobe.fake_subsurface = flatness * reflected;
  }
  if (color.is_black() && sheen == 0.F) return;
  bsdf.add(lobe, scale * share);
}

int Disney::max_lobes() const {
  return 2 + (clearcoat_.is_black() ? 0 : 1) + (spec_trans_.is_black() ? 0 : 1) + (thin_ ? 1 : 0);
}

}  // namespace ajar
