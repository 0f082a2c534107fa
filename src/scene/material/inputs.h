#pragma once
#include <cstddef>

#include "scene/bsdf/microfacet.h"
#include "scene/desc/scene_desc.h"
#include "scene/texture/texture.h"

/// How materials read their textures: whatever a texture says, a lobe gets values it can work with.
namespace ajar {

/// Finds textures by id while materials are built.
class Slots {
 public:
  explicit Slots(const TextureList& textures) : textures_(textures) {}
  /// The texture, or the constant `fallback` if the id is none.
  TextureSlot operator()(desc::TextureId id, const Spectrum& fallback) const {
    if (id < 0 || static_cast<std::size_t>(id) >= textures_.size()) return TextureSlot(fallback);
    return TextureSlot(textures_[id].get());
  }
  TextureSlot operator()(desc::TextureId id, float fallback) const {
    return (*this)(id, Spectrum(fallback));
  }

 private:
  const TextureList& textures_;
};

/// `x` in [low, high]; NaN becomes `low`.
inline float within(float x, float low, float high) { return x > low ? std::min(x, high) : low; }
/// A reflectance or a weight: lanes in [0, 1].
inline Spectrum reflectance(const TextureSlot& slot, const SurfacePoint& at) {
  return map_lanes(slot.eval(at), [](float x) { return within(x, 0.F, 1.F); });
}
inline float weight(const TextureSlot& slot, const SurfacePoint& at) {
  return within(slot.eval_float(at), 0.F, 1.F);
}
/// Index of refraction in [0.05, 20]; nonsense (zero, negative, NaN) counts as 1.
inline float index_of_refraction(const TextureSlot& slot, const SurfacePoint& at) {
  const float eta = slot.eval_float(at);
  return eta > 0.F ? std::clamp(eta, 0.05F, 20.F) : 1.F;
}
/// True if a boundary with this index bends light so little that rough refraction, whose lobe then
/// narrows to nothing, must be treated as smooth.
inline bool index_matched(float eta) { return std::abs(eta - 1.F) < 1e-3F; }

/// Roughness along u and v, as microfacet α. Constant textures are converted only once.
class RoughnessSlot {
 public:
  /// Without `v`, the roughness is isotropic.
  RoughnessSlot(const Slots& slots, desc::TextureId u, desc::TextureId v, float fallback,
                bool remap)
      : u_(slots(u, fallback)), v_(v == desc::kNone ? u_ : slots(v, fallback)), remap_(remap) {
    if (u_.is_constant()) u_ = TextureSlot(Spectrum(alpha(u_.eval_float({}))));
    if (v_.is_constant()) v_ = TextureSlot(Spectrum(alpha(v_.eval_float({}))));
    isotropic_ = v == desc::kNone || u == v ||
                 (u_.is_constant() && v_.is_constant() && u_.eval_float({}) == v_.eval_float({}));
  }
  bool isotropic() const { return isotropic_; }
  Microfacets facets(FacetModel model, const SurfacePoint& at) const {
    const float u = evaluate(u_, at);
    return {model, u, isotropic_ ? u : evaluate(v_, at)};
  }

 private:
  float alpha(float roughness) const { return remap_ ? roughness_to_alpha(roughness) : roughness; }
  float evaluate(const TextureSlot& slot, const SurfacePoint& at) const {
    return slot.is_constant() ? slot.eval_float(at) : alpha(slot.eval_float(at));
  }

  TextureSlot u_;
  TextureSlot v_;
  bool remap_;
  bool isotropic_ = true;
};

}  // namespace ajar
