#pragma once
#include "scene/texture/texture.h"

namespace ajar {

/// The same value everywhere.
class ConstantTexture final : public Texture {
 public:
  explicit ConstantTexture(const Spectrum& value) : value_(value) {}
  Spectrum eval(const SurfacePoint& /*at*/) const override { return value_; }
  float eval_float(const SurfacePoint& /*at*/) const override { return value_[0]; }
  const Spectrum* constant() const override { return &value_; }

 private:
  Spectrum value_;
};

}  // namespace ajar
