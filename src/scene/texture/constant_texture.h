#pragma once
#include "scene/texture/texture.h"

namespace ajar {

/// Constant texture.
class ConstantTexture final : public Texture {
 public:
  explicit ConstantTexture(const Spectrum& value, bool is_stand_in = false)
      : value_(value), is_stand_in_(is_stand_in) {}
  Spectrum eval(const SurfacePoint& /*at*/) const override { return value_; }
  float eval_float(const SurfacePoint& /*at*/) const override { return value_[0]; }
  const Spectrum* constant() const override { return &value_; }
  bool is_stand_in() const override { return is_stand_in_; }

 private:
  Spectrum value_;
  bool is_stand_in_;
};

}  // namespace ajar
