#pragma once
#include "scene/bsdf/lobe.h"

namespace ajar {

template <typename Base>
concept MayBeDiffuse = requires(const Base& base, const Vec3& wo) {
  base.is_diffuse(wo, 0.F);
};

/// A lobe below a layer, which weakens it for both directions. `Layer` says
///
///     float left(wo, wi) const;    // factor of the base's f
///     float left_albedo(wo) const; // factor of its albedo
template <typename Base, typename Layer>
struct UnderLayer {
  static constexpr bool kSpecular = false;
  static_assert(!Base::kSpecular);
  Base base;
  Layer layer;

  LobeValue evaluate(const Vec3& wo, const Vec3& wi, bool transmission, TransportMode mode) const {
    LobeValue v = base.evaluate(wo, wi, transmission, mode);
    v.value *= layer.left(wo, wi);
    return v;
  }
  std::optional<LobeSample> sample(const Vec3& wo, const BsdfUniforms& u, const Vec3& ng,
                                   TransportMode mode) const {
    std::optional<LobeSample> s = base.sample(wo, u, ng, mode);
    if (s) s->weight *= layer.left(wo, s->wi);
    return s;
  }
  LobeInverse inverse(const Vec3& wo, const Vec3& wi, float u_lobe, const Vec3& ng) const {
    return base.inverse(wo, wi, u_lobe, ng);
  }
  bool is_diffuse(const Vec3& wo, float u_lobe) const requires MayBeDiffuse<Base> {
    return base.is_diffuse(wo, u_lobe);
  }
  Spectrum albedo(const Vec3& wo) const { return base.albedo(wo) * layer.left_albedo(wo); }
};

}  // namespace ajar
