#pragma once
#include "scene/material/inputs.h"
#include "scene/material/material.h"

namespace ajar {

/// Diffuse and glossy scattering to both sides, split by `reflect` and `transmit`; index 1.5.
class Translucent final : public Material {
 public:
  Translucent(const desc::TranslucentMaterial& d, const Slots& slots)
      : kd_(slots(d.kd, 0.25F)),
        ks_(slots(d.ks, 0.25F)),
        roughness_(slots, d.roughness, desc::kNone, 0.1F, d.remap_roughness),
        reflect_(slots(d.reflect, 0.5F)),
        transmit_(slots(d.transmit, 0.5F)) {}
  void add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const override {
    const Spectrum reflect = reflectance(reflect_, at);
    const Spectrum transmit = reflectance(transmit_, at);
    const Spectrum kd = scale * reflectance(kd_, at);
    bsdf.add(Lambert{}, kd * reflect);
    bsdf.add(LambertTransmission{}, kd * transmit);
    const Spectrum ks = reflectance(ks_, at);
    if (ks.is_black() || (reflect.is_black() && transmit.is_black())) return;
    bsdf.add(RoughDielectric{roughness_.facets(FacetModel::Ggx, at), PackedSpectrum(ks * reflect),
                             PackedSpectrum(ks * transmit), 1.5F},
             scale);
  }
  int max_lobes() const override { return 3; }

 private:
  TextureSlot kd_;
  TextureSlot ks_;
  RoughnessSlot roughness_;
  TextureSlot reflect_;
  TextureSlot transmit_;
};

}  // namespace ajar
