#pragma once
#include "scene/material/inputs.h"
#include "scene/material/material.h"

namespace ajar {

/// Diffuse base under a glossy coat.
class Substrate final : public Material {
 public:
  Substrate(const desc::SubstrateMaterial& d, const Slots& slots)
      : kd_(slots(d.kd, 0.5F)),
        ks_(slots(d.ks, 0.5F)),
        roughness_(slots, d.u_roughness, d.v_roughness, 0.1F, d.remap_roughness) {
    needs_tangent = !roughness_.isotropic();
  }
  void add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const override {
    const Spectrum kd = reflectance(kd_, at);
    const Spectrum ks = reflectance(ks_, at);
    if (kd.is_black() && ks.is_black()) return;
    bsdf.add(FresnelBlend{roughness_.facets(FacetModel::Ggx, at), PackedSpectrum(kd),
                          PackedSpectrum(ks)},
             scale);
  }
  int max_lobes() const override { return 1; }

 private:
  TextureSlot kd_;
  TextureSlot ks_;
  RoughnessSlot roughness_;
};

}  // namespace ajar
