#pragma once
#include "scene/bsdf/microfacet_reflection.h"

namespace ajar {

/// Fresnel term of Disney's specular lobe: between the exact dielectric one and Schlick's, which
/// starts at `r0`, each with its share. Source: Burley 2015, as in pbrt-v3.
struct DisneyFresnel {
  PackedSpectrum r0;
  float metallic = 0.F;
  float eta = 1.5F;
  float dielectric_share = 1.F - metallic;
  bool is_sheet = false;  ///< the same medium on both sides

  Spectrum operator()(float cos_i, bool front) const {
    const Spectrum dielectric = DielectricFresnel{eta}(cos_i, front || is_sheet);
    const Spectrum base = r0.unpack();
    const Spectrum metal = base + schlick_weight(cos_i) * (Spectrum(1.F) - base);
    return dielectric * dielectric_share + metal * metallic;
  }
};

/// Main highlight of Disney's model.
using DisneySpecular = MicrofacetReflection<DisneyFresnel>;

}  // namespace ajar
