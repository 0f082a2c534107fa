#pragma once
#include <memory>
#include <vector>

#include "core/spectrum.h"
#include "core/warnings.h"
#include "scene/desc/scene_desc.h"
#include "scene/surface_point.h"

namespace ajar {

inline Spectrum rgb_spectrum(const desc::Rgb& rgb) { return {rgb.x, rgb.y, rgb.z}; }

/// A function over surfaces. Immutable and safe to call from any thread.
class Texture {
 public:
  virtual ~Texture() = default;
  virtual Spectrum eval(const SurfacePoint& at) const = 0;
  /// Value as a single number: the first lane, eval(at)[0]; of colour images the luminance, as in
  /// pbrt-v3.
  virtual float eval_float(const SurfacePoint& at) const { return eval(at)[0]; }
  /// The value, if it is the same everywhere.
  virtual const Spectrum* constant() const { return nullptr; }
  /// True if it replaces a file that could not be read.
  virtual bool is_stand_in() const { return false; }
};

/// A texture or a constant, without a virtual call in the common case. Copyable, does not own.
class TextureSlot {
 public:
  TextureSlot() = default;
  explicit TextureSlot(const Spectrum& value) : value_(value) {}
  explicit TextureSlot(const Texture* texture) {
    if (texture == nullptr) return;
    if (const Spectrum* value = texture->constant()) {
      value_ = *value;
    } else {
      texture_ = texture;
    }
  }
  Spectrum eval(const SurfacePoint& at) const { return texture_ ? texture_->eval(at) : value_; }
  float eval_float(const SurfacePoint& at) const {
    return texture_ ? texture_->eval_float(at) : value_[0];
  }
  /// True if it is the constant zero.
  bool is_black() const { return texture_ == nullptr && value_.is_black(); }
  bool is_constant() const { return texture_ == nullptr; }

 private:
  const Texture* texture_ = nullptr;
  Spectrum value_;
};

using TextureList = std::vector<std::unique_ptr<const Texture>>;

/// The value of a parameter: a float, a colour, or one of the textures.
TextureSlot texture_slot(const desc::Value& value, const TextureList& textures);

/// Builds all textures of a scene; entry i is texture id i. Image files are read here, each once.
/// An image that cannot be read becomes magenta and a warning.
TextureList build_textures(const desc::SceneDesc& scene, Warnings& warnings);

}  // namespace ajar
