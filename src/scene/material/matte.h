#pragma once
#include "scene/material/inputs.h"
#include "scene/material/material.h"

namespace ajar {

/// Diffuse: Lambert, or Oren–Nayar where `sigma` (degrees) is not zero.
class Matte final : public Material {
 public:
  Matte(const desc::MatteMaterial& d, const Slots& slots)
      : kd_(slots(d.kd, 0.5F)), sigma_(slots(d.sigma, 0.F)) {}
  void add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const override {
    const Spectrum kd = scale * reflectance(kd_, at);
    const float sigma = within(sigma_.eval_float(at), 0.F, 90.F);
    if (sigma == 0.F) {
      bsdf.add(Lambert{}, kd);
    } else {
      bsdf.add(OrenNayar(sigma * (kPi / 180.F)), kd);
    }
  }
  int max_lobes() const override { return 1; }

 private:
  TextureSlot kd_;
  TextureSlot sigma_;
};

}  // namespace ajar
