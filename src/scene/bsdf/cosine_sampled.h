#pragma once
#include "scene/bsdf/lobe.h"

namespace ajar {

/// A reflecting lobe that is sampled by the cosine. `Lobe`, which derives from it, says only
///
///     Spectrum times_pi(wo, wi) const;  // π f
///     Spectrum albedo(wo) const;
template <typename Lobe>
struct CosineSampled {
  static constexpr bool kSpecular = false;

  LobeValue evaluate(const Vec3& wo, const Vec3& wi, bool transmission, TransportMode) const {
    if (transmission) return {};
    return {self().times_pi(wo, wi) * cosine_pdf(wi), cosine_pdf(wi), cosine_pdf(wo)};
  }
  std::optional<LobeSample> sample(const Vec3& wo, const BsdfUniforms& u, const Vec3& ng,
                                   TransportMode) const {
    const Vec3 wi = cosine_around(u.direction, ng);
    return LobeSample{wi, self().times_pi(wo, wi), cosine_pdf(wi), cosine_pdf(wo)};
  }
  LobeInverse inverse(const Vec3&, const Vec3& wi, float, const Vec3& ng) const {
    return cosine_inverse(wi, ng);
  }
  bool is_diffuse(const Vec3&, float) const { return true; }

 private:
  const Lobe& self() const { return static_cast<const Lobe&>(*this); }
};

}  // namespace ajar
