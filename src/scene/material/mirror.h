#pragma once
#include "scene/material/inputs.h"
#include "scene/material/material.h"

namespace ajar {

/// Perfect mirror with a constant reflectance.
class MirrorSurface final : public Material {
 public:
  MirrorSurface(const desc::MirrorMaterial& d, const Slots& slots) : kr_(slots(d.kr, 0.9F)) {}
  void add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const override {
    bsdf.add(Mirror{}, scale * reflectance(kr_, at));
  }
  int max_lobes() const override { return 1; }

 private:
  TextureSlot kr_;
};

}  // namespace ajar
