#pragma once
#include "scene/material/inputs.h"
#include "scene/material/material.h"

namespace ajar {

/// Dielectric boundary: smooth, rough (if either roughness is not zero), or a thin smooth pane.
class Glass final : public Material {
 public:
  Glass(const desc::GlassMaterial& d, const Slots& slots)
      : kr_(slots(d.kr, 1.F)),
        kt_(slots(d.kt, 1.F)),
        eta_(slots(d.eta, 1.5F)),
        roughness_(slots, d.u_roughness, d.v_roughness, 0.F, d.remap_roughness),
        rough_(!slots(d.u_roughness, 0.F).is_black() || !slots(d.v_roughness, 0.F).is_black()),
        thin_(d.thin) {
    needs_tangent = rough_ && !thin_ && !roughness_.isotropic();
  }
  void add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const override {
    const PackedSpectrum kr(reflectance(kr_, at));
    const PackedSpectrum kt(reflectance(kt_, at));
    if (kr.average() == 0.F && kt.average() == 0.F) return;
    const float eta = index_of_refraction(eta_, at);
    if (thin_) {
      bsdf.add(ThinDielectric{kr, kt, eta}, scale);
    } else if (rough_ && !index_matched(eta)) {
      bsdf.add(RoughDielectric{roughness_.facets(FacetModel::Ggx, at), kr, kt, eta}, scale);
    } else {
      bsdf.add(SmoothDielectric{kr, kt, eta}, scale);
    }
  }
  int max_lobes() const override { return 1; }
  /// True if it was asked to be thin and rough, which is not modelled: it will be smooth.
  bool ignores_roughness() const { return thin_ && rough_; }

 private:
  TextureSlot kr_;
  TextureSlot kt_;
  TextureSlot eta_;
  RoughnessSlot roughness_;
  bool rough_;
  bool thin_;
};

}  // namespace ajar
