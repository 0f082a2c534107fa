#include "scene/material/inputs.h"

namespace ajar {
namespace {

/// Diffuse base under a glossy coat.
class CoatedDiffuse final : public Material {
 public:
  explicit CoatedDiffuse(const MaterialInputs& in)
      : diffuse_(in.slot("diffuse_reflectance")),
        glossy_(in.slot("glossy_reflectance")),
        roughness_(in) {
    needs_tangent = !roughness_.isotropic();
  }
  void add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const override {
    const Spectrum kd = reflectance(diffuse_, at);
    const Spectrum ks = reflectance(glossy_, at);
    if (kd.is_black() && ks.is_black()) return;
    bsdf.add(FresnelBlend{roughness_.facets(FacetModel::Ggx, at), PackedSpectrum(kd),
                          PackedSpectrum(ks)},
             scale);
  }
  int max_lobes() const override { return 1; }

 private:
  TextureSlot diffuse_;
  TextureSlot glossy_;
  RoughnessSlot roughness_;
};

}  // namespace

MaterialModel coated_diffuse_material() {
  return {{.name = "coated_diffuse",
           .summary = "diffuse base under a glossy coat (Ashikhmin-Shirley)",
           .source = "Ashikhmin and Shirley 2000",
           .parameters = declare::joined(
               {declare::reflectance("diffuse_reflectance", "0.5", "of the base"),
                declare::reflectance("glossy_reflectance", "0.5", "of the coat, seen from above")},
               roughness_inputs("0.1"))},
          make<CoatedDiffuse>};
}

}  // namespace ajar
