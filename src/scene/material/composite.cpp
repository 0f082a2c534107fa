#include "scene/material/inputs.h"

namespace ajar {
namespace {

/// Sum of a diffuse, a glossy, a mirror and a refracting part, all scaled by `opacity`; the rest
/// lets light pass straight through.
class Composite final : public Material {
 public:
  explicit Composite(const MaterialInputs& in)
      : diffuse_(in.slot("diffuse_reflectance")),
        glossy_(in.slot("glossy_reflectance")),
        mirror_(in.slot("mirror_reflectance")),
        transmittance_(in.slot("transmittance")),
        roughness_(in),
        eta_(in.slot("eta")),
        opacity_(in.slot("opacity")),
        uncounted_(in.node().flag("uncounted")) {
    passes_uncounted = uncounted_;
    index_varies = !eta_.is_constant();
    needs_tangent = !roughness_.isotropic();
  }
  void add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const override {
    const Spectrum opacity = reflectance(opacity_, at);
    bsdf.add(PassThrough{uncounted_}, scale * (Spectrum(1.F) - opacity));
    const Spectrum opaque = scale * opacity;
    const float eta = index_of_refraction(eta_, at);
    bsdf.add(Lambert{}, opaque * reflectance(diffuse_, at));
    const Spectrum ks = opaque * reflectance(glossy_, at);
    if (!ks.is_black()) {
      bsdf.add(DielectricReflection{roughness_.facets(FacetModel::Ggx, at), {eta}}, ks);
    }
    if (!mirror_.is_black()) bsdf.add(SpecularReflection{eta}, opaque * reflectance(mirror_, at));
    if (!transmittance_.is_black())
      bsdf.add(SpecularTransmission{eta}, opaque * reflectance(transmittance_, at));
  }
  int max_lobes() const override {
    const bool opaque = opacity_.is_constant() && opacity_.eval({}).min() >= 1.F;
    return (opaque ? 0 : 1) + (diffuse_.is_black() ? 0 : 1) + (glossy_.is_black() ? 0 : 1) +
           (mirror_.is_black() ? 0 : 1) + (transmittance_.is_black() ? 0 : 1);
  }

 private:
  TextureSlot diffuse_;
  TextureSlot glossy_;
  TextureSlot mirror_;
  TextureSlot transmittance_;
  RoughnessSlot roughness_;
  TextureSlot eta_;
  TextureSlot opacity_;
  bool uncounted_;
};

}  // namespace

MaterialModel composite_material() {
  return {
      {.name = "composite",
       .summary = "diffuse, glossy, mirror and transparent parts with opacity",
       .source = "Pharr et al. 2016, section 9.2",
       .parameters = declare::joined(
           {declare::reflectance("diffuse_reflectance", "0.25", "of the diffuse part"),
            declare::reflectance("glossy_reflectance", "0.25",
                                 "tint of the rough dielectric gloss"),
            declare::reflectance("mirror_reflectance", "0", "tint of the smooth dielectric gloss"),
            declare::reflectance("transmittance", "0", "tint of what is refracted"), index_input(),
            declare::reflectance("opacity", "1", "share of light that does not pass straight on"),
            declare::flag("uncounted",
                          "what passes straight on adds nothing to the depth of a path")},
           roughness_inputs("0.1"))},
      make<Composite>};
}

}  // namespace ajar
