#pragma once
#include "scene/material/inputs.h"
#include "scene/material/material.h"

namespace ajar {

/// Rough conductor; copper unless told otherwise.
class Metal final : public Material {
 public:
  Metal(const desc::MetalMaterial& d, const Slots& slots)
      : eta_(slots(d.eta, Spectrum(0.200438F, 0.924033F, 1.102212F))),
        k_(slots(d.k, Spectrum(3.912949F, 2.452848F, 2.142188F))),
        roughness_(slots, d.u_roughness, d.v_roughness, 0.01F, d.remap_roughness),
        model_(d.model == desc::MicrofacetModel::Beckmann ? FacetModel::Beckmann
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

}  // namespace ajar
