#include "scene/material/inputs.h"

namespace ajar {
namespace {

/// Rough conductor; copper unless told otherwise.
class ConductorSurface final : public Material {
 public:
  explicit ConductorSurface(const MaterialInputs& in)
      : eta_(in.slot("eta")),
        k_(in.slot("k")),
        roughness_(in),
        model_(in.node().text("distribution") == "beckmann" ? FacetModel::Beckmann
                                                            : FacetModel::Ggx) {
    needs_tangent = !roughness_.isotropic();
  }
  void add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const override {
    bsdf.add(Conductor{roughness_.facets(model_, at), ConductorFresnel(eta_.eval(at), k_.eval(at))},
             scale);
  }
  int max_lobes() const override { return 1; }

 private:
  TextureSlot eta_;
  TextureSlot k_;
  RoughnessSlot roughness_;
  FacetModel model_;
};

}  // namespace

MaterialModel conductor_material() {
  return {{.name = "conductor",
           .summary = "rough conductor with a measured or given index of refraction",
           .source = "Walter et al. 2007",
           .parameters = declare::joined(
               {declare::textured_color("eta", "0.200982586 0.923764288 1.10221601",
                                        "index of refraction; copper's, unless given"),
                declare::textured_color("k", "3.91325855 2.45303726 2.14209414",
                                        "extinction coefficient; copper's, unless given"),
                choice_parameter("distribution", {"ggx", "beckmann"},
                                 "distribution of the facets' normals")},
               roughness_inputs("0.01"))},
          make<ConductorSurface>};
}

}  // namespace ajar
