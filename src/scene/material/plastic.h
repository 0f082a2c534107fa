#pragma once
#include "scene/material/inputs.h"
#include "scene/material/material.h"

namespace ajar {

/// Diffuse base and a dielectric highlight, added without any coupling.
class Plastic final : public Material {
 public:
  Plastic(const desc::PlasticMaterial& d, const Slots& slots)
      : kd_(slots(d.kd, 0.25F)),
        ks_(slots(d.ks, 0.25F)),
        roughness_(slots, d.roughness, desc::kNone, 0.1F, d.remap_roughness) {}
  void add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const override {
    bsdf.add(Lambert{}, scale * reflectance(kd_, at));
    const Spectrum ks = scale * reflectance(ks_, at);
    if (ks.is_black()) return;
    // pbrt-v3 builds this Fresnel term with the indices in the order (1.5, 1), as if the light came
    // from within the plastic: reflection is total from 42° on. Its pictures depend on it.
    bsdf.add(DielectricReflection{roughness_.facets(FacetModel::Ggx, at), {1.F / 1.5F}}, ks);
  }
  int max_lobes() const override { return 2; }

 private:
  TextureSlot kd_;
  TextureSlot ks_;
  RoughnessSlot roughness_;
};

}  // namespace ajar
