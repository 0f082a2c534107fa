#include "scene/material/inputs.h"

namespace ajar {
namespace {

/// Diffuse base and a dielectric highlight, added without any coupling.
class Plastic final : public Material {
 public:
  explicit Plastic(const MaterialInputs& in)
      : diffuse_(in.slot("diffuse_reflectance")),
        glossy_(in.slot("glossy_reflectance")),
        roughness_(in) {}
  void add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const override {
    bsdf.add(Lambert{}, scale * reflectance(diffuse_, at));
    const Spectrum ks = scale * reflectance(glossy_, at);
    if (ks.is_black()) return;
    // pbrt-v3 builds this Fresnel term with the indices in the order (1.5, 1), as if the light came
    // from within the plastic: reflection is total from 42° on. Its pictures depend on it.
    bsdf.add(DielectricReflection{roughness_.facets(FacetModel::Ggx, at), {1.F / 1.5F}}, ks);
  }
  int max_lobes() const override { return 2; }

 private:
  TextureSlot diffuse_;
  TextureSlot glossy_;
  RoughnessSlot roughness_;
};

}  // namespace

MaterialModel plastic_material() {
  return {{.name = "plastic",
           .summary = "diffuse base with a rough dielectric gloss",
           .source = "Pharr et al. 2016, section 9.2",
           .parameters = declare::joined(
               {declare::reflectance("diffuse_reflectance", "0.25", "of the base"),
                declare::reflectance("glossy_reflectance", "0.25", "tint of the gloss")},
               isotropic_roughness_inputs("0.1"))},
          make<Plastic>};
}

}  // namespace ajar
