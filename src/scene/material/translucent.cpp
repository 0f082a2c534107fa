#include "scene/material/inputs.h"

namespace ajar {
namespace {

/// Diffuse and glossy scattering to both sides, split by `reflect` and `transmit`; index 1.5.
class Translucent final : public Material {
 public:
  explicit Translucent(const MaterialInputs& in)
      : diffuse_(in.slot("diffuse")),
        glossy_(in.slot("glossy")),
        roughness_(in),
        reflect_(in.slot("reflectance")),
        transmit_(in.slot("transmittance")) {}
  void add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const override {
    const Spectrum reflect = reflectance(reflect_, at);
    const Spectrum transmit = reflectance(transmit_, at);
    const Spectrum kd = scale * reflectance(diffuse_, at);
    bsdf.add(Lambert{}, kd * reflect);
    bsdf.add(LambertTransmission{}, kd * transmit);
    const Spectrum ks = reflectance(glossy_, at);
    if (ks.is_black() || (reflect.is_black() && transmit.is_black())) return;
    bsdf.add(RoughDielectric{roughness_.facets(FacetModel::Ggx, at), PackedSpectrum(ks * reflect),
                             PackedSpectrum(ks * transmit), 1.5F},
             scale);
  }
  int max_lobes() const override { return 3; }

 private:
  TextureSlot diffuse_;
  TextureSlot glossy_;
  RoughnessSlot roughness_;
  TextureSlot reflect_;
  TextureSlot transmit_;
};

}  // namespace

MaterialModel translucent_material() {
  return {
      {.name = "translucent",
       .summary = "diffuse and glossy reflection and transmission",
       .source = "Pharr et al. 2016, section 9.2",
       .parameters = declare::joined(
           {declare::reflectance("diffuse", "0.25", "share of light that it scatters diffusely"),
            declare::reflectance("glossy", "0.25", "tint of the gloss"),
            declare::reflectance("reflectance", "0.5", "share of both that is reflected"),
            declare::reflectance("transmittance", "0.5", "share of both that is transmitted")},
           isotropic_roughness_inputs("0.1"))},
      make<Translucent>};
}

}  // namespace ajar
