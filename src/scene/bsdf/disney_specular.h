#pragma once
#include "scene/bsdf/microfacet_reflection.h"

namespace ajar {

/// Fresnel term of Disney's specular lobe: between the exact dielectric one and Schlick's, which
/// starts at `r0`, each with its share. Seen from behind, it is the same: the inside is opaque, or
/// air. Source: Burley 2015, as in pbrt-v3.
struct DisneyFresnel {
  PackedSpectrum r0;
  float metallic = 0.F;
  float eta = 1.5F;
  float dielectric_share = 1.F - metallic;

  Spectrum operator()(float cos_i, bool /*front*/) const {
    const Spectrum dielectric = DielectricFresnel{eta}(cos_i, true);
    const Spectrum base = r0.unpack();
    const Spectrum metal = base + schlick_weight(cos_i) * (Spectrum(1.F) - base);
    return dielectric * dielectric_share + metal * metallic;
  }
};

/// Fresnel term of Disney's glass where light goes in: from within, there is only the share that is
/// glass.
struct DisneyGlassFresnel : DisneyFresnel {
  float glass = 1.F;

  Spectrum operator()(float cos_i, bool front) const {
    if (front) return DisneyFresnel::operator()(cos_i, true);
    return DielectricFresnel{eta}(cos_i, false) * glass;
  }
};

/// Main highlight of Disney's model.
using DisneySpecular = MicrofacetReflection<DisneyFresnel>;
using DisneyGlassSpecular = MicrofacetReflection<DisneyGlassFresnel>;

}  // namespace ajar
