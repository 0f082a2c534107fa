#pragma once
#include "scene/material/inputs.h"
#include "scene/material/material.h"

namespace ajar {

/// Disney's "principled" model. Sources: Burley 2012 and 2015, combined as pbrt-v3 does. (From
/// behind, where pbrt's Schlick term is 1 at any angle, ours is the same as from the front.)
class Disney final : public Material {
 public:
  Disney(const desc::DisneyMaterial& d, const Slots& slots);
  void add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const override;
  int max_lobes() const override;

 private:
  void add_diffuse(const SurfacePoint& at, const Spectrum& scale, const Spectrum& color,
                   const Spectrum& tint, float roughness, float share, Bsdf& bsdf) const;

  TextureSlot color_, metallic_, eta_, roughness_, specular_tint_, anisotropic_, sheen_,
      sheen_tint_, clearcoat_, clearcoat_gloss_, spec_trans_, flatness_, diff_trans_;
  bool thin_;
};

}  // namespace ajar
