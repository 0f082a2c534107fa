#pragma once
#include "scene/material/inputs.h"
#include "scene/material/material.h"

namespace ajar {

/// Sum of a diffuse, a glossy, a mirror and a refracting part, all scaled by `opacity`; what is not
/// opaque lets light pass straight through.
class Uber final : public Material {
 public:
  Uber(const desc::UberMaterial& d, const Slots& slots)
      : kd_(slots(d.kd, 0.25F)),
        ks_(slots(d.ks, 0.25F)),
        kr_(slots(d.kr, 0.F)),
        kt_(slots(d.kt, 0.F)),
        roughness_(slots, d.u_roughness, d.v_roughness, 0.1F, d.remap_roughness),
        eta_(slots(d.eta, 1.5F)),
        opacity_(slots(d.opacity, 1.F)) {
    needs_tangent = !roughness_.isotropic();
  }
  void add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const override {
    const Spectrum opacity = reflectance(opacity_, at);
    bsdf.add(PassThrough{}, scale * (Spectrum(1.F) - opacity));
    const Spectrum opaque = scale * opacity;
    const float eta = index_of_refraction(eta_, at);
    bsdf.add(Lambert{}, opaque * reflectance(kd_, at));
    const Spectrum ks = opaque * reflectance(ks_, at);
    if (!ks.is_black()) {
      bsdf.add(DielectricReflection{roughness_.facets(FacetModel::Ggx, at), {eta}}, ks);
    }
    if (!kr_.is_black()) bsdf.add(SpecularReflection{eta}, opaque * reflectance(kr_, at));
    if (!kt_.is_black()) bsdf.add(SpecularTransmission{eta}, opaque * reflectance(kt_, at));
  }
  int max_lobes() const override {
    const bool opaque = opacity_.is_constant() && opacity_.eval({}).min() >= 1.F;
    return (opaque ? 0 : 1) + (kd_.is_black() ? 0 : 1) + (ks_.is_black() ? 0 : 1) +
           (kr_.is_black() ? 0 : 1) + (kt_.is_black() ? 0 : 1);
  }

 private:
  TextureSlot kd_;
  TextureSlot ks_;
  TextureSlot kr_;
  TextureSlot kt_;
  RoughnessSlot roughness_;
  TextureSlot eta_;
  TextureSlot opacity_;
};

}  // namespace ajar
