#include "scene/material/inputs.h"
#include "scene/material/metal.h"

namespace ajar {
namespace {

/// Rough or polished conductor; copper by default.
class ConductorSurface final : public Material {
 public:
  explicit ConductorSurface(const MaterialInputs& in)
      : metal_(in, "eta", "k", "reflectance"),
        roughness_(in),
        model_(facet_model(in.node())),
        smooth_(in.node().text("distribution") == "smooth") {
    needs_tangent = !smooth_ && !roughness_.isotropic();
  }
  void add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const override {
    const ConductorFresnel fresnel(metal_.eta(at), metal_.k(at));
    if (smooth_) {
      bsdf.add(SmoothConductor{fresnel}, scale);
    } else {
      bsdf.add(Conductor{roughness_.facets(model_, at), fresnel}, scale);
    }
  }
  int max_lobes() const override { return 1; }

 private:
  MetalSlots metal_;
  RoughnessSlot roughness_;
  FacetModel model_;
  bool smooth_;
};

}  // namespace

MaterialModel conductor_material() {
  return {{.name = "conductor",
           .summary = "rough conductor with a measured or given index of refraction",
           .source = "Walter et al. 2007",
           .parameters = declare::joined(
               declare::joined(metal_inputs("eta", "k", "reflectance"), facet_inputs({"smooth"})),
               roughness_inputs("0.01"))},
          make<ConductorSurface>};
}

}  // namespace ajar
