#include "scene/bsdf/bsdf.h"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace ajar {
namespace {
template <typename L>
constexpr bool kIsSpecular = std::remove_cvref_t<L>::kSpecular;

bool is_specular(const Lobe& lobe) {
  return visit_lobe(lobe, [](const auto& l) { return kIsSpecular<decltype(l)>; });
}
}  // namespace

/// Probabilities of the lobes.
struct Bsdf::Weights {
  std::array<float, kMaxLobes> probability;
};

/// Two directions in the shading frame, and how the geometric normal sees them.
struct Bsdf::Pair {
  Vec3 wo;
  Vec3 wi;
  float wo_side;  ///< wo · ng
  float wi_side;
  bool transmission;
  bool valid;  ///< no direction is grazing
};

Bsdf::Pair Bsdf::classify(const Vec3& wo, const Vec3& wi) const {
  const Frame shading = frame();
  const float wo_side = dot(wo, ng());
  const float wi_side = dot(wi, ng());
  const Vec3 o = shading.to_local(wo);
  const Vec3 i = shading.to_local(wi);
  const float least = std::min(std::min(std::abs(wo_side), std::abs(wi_side)),
                               std::min(std::abs(o.z), std::abs(i.z)));
  return {o, i, wo_side, wi_side, wo_side * wi_side < 0.F, least >= kGrazing};
}

Bsdf::Weights Bsdf::weights(const Vec3& local_wo) const {
  Weights result;
  float sum = 0.F;
  for (int k = 0; k < count_; ++k) {
    const Entry& e = entry(k);
    const Spectrum albedo = visit_lobe(e.lobe, [&](const auto& l) { return l.albedo(local_wo); });
    const float weight = (e.scale * albedo).average();
    result.probability[k] = weight;
    sum += weight;
  }
  // One over a number that is not normal may be infinite.
  const float scale = sum >= std::numeric_limits<float>::min() ? 1.F / sum : 0.F;
  for (int k = 0; k < count_; ++k) result.probability[k] *= scale;
  return result;
}

float Bsdf::rough_eta() const {
  for (int k = 0; k < count_; ++k) {
    if (const auto* lobe = std::get_if<RoughDielectric>(&entry(k).lobe)) return lobe->eta;
  }
  return 1.F;
}

Spectrum Bsdf::value(int index, const Pair& pair, TransportMode mode) const {
  const Entry& e = entry(index);
  return e.scale * visit_lobe(e.lobe, [&](const auto& l) {
           if constexpr (kIsSpecular<decltype(l)>) {
             return Spectrum();
           } else {
             return l.evaluate(pair.wo, pair.wi, pair.transmission, mode).value;
           }
         });
}

LobeValue Bsdf::evaluate(int index, const Pair& pair, TransportMode mode) const {
  return visit_lobe(entry(index).lobe, [&](const auto& l) {
    if constexpr (kIsSpecular<decltype(l)>) {
      return LobeValue();
    } else {
      return l.evaluate(pair.wo, pair.wi, pair.transmission, mode);
    }
  });
}

Spectrum Bsdf::eval(const Vec3& wo, const Vec3& wi, TransportMode mode) const {
  const Pair pair = classify(wo, wi);
  if (!pair.valid) return {};
  Spectrum sum;
  for (int k = 0; k < count_; ++k) sum += value(k, pair, mode);
  if (mode == TransportMode::Importance) {
    sum *= std::abs(pair.wo.z * pair.wi_side / (pair.wo_side * pair.wi.z));
  }
  return sum;
}

BsdfValue Bsdf::evaluate(const Vec3& wo, const Vec3& wi, TransportMode mode) const {
  const Pair pair = classify(wo, wi);
  if (!pair.valid || !connectible_) return {};
  BsdfValue result;
  if (count_ == 1) {
    const LobeValue v = evaluate(0, pair, mode);
    result = {entry(0).scale * v.value, Pdf<SolidAngle>(v.pdf)};
  } else {
    const Weights choice = weights(pair.wo);
    float density = 0.F;
    for (int k = 0; k < count_; ++k) {
      const LobeValue v = evaluate(k, pair, mode);
      result.value += entry(k).scale * v.value;
      if (choice.probability[k] > 0.F) density += choice.probability[k] * v.pdf;
    }
    result.pdf = Pdf<SolidAngle>(density);
  }
  if (mode == TransportMode::Importance) {
    result.value *= std::abs(pair.wo.z * pair.wi_side / (pair.wo_side * pair.wi.z));
  }
  return result;
}

Pdf<SolidAngle> Bsdf::pdf(const Vec3& wo, const Vec3& wi) const {
  const Pair pair = classify(wo, wi);
  if (!pair.valid || !connectible_) return {};
  const auto lobe_pdf = [&](int index) {
    return visit_lobe(entry(index).lobe, [&](const auto& l) {
      if constexpr (kIsSpecular<decltype(l)>) {
        return 0.F;
      } else {
        return l.evaluate(pair.wo, pair.wi, pair.transmission, TransportMode::Radiance).pdf;
      }
    });
  };
  if (count_ == 1) return Pdf<SolidAngle>(lobe_pdf(0));
  const Weights choice = weights(pair.wo);
  float sum = 0.F;
  for (int k = 0; k < count_; ++k) {
    if (choice.probability[k] > 0.F) sum += choice.probability[k] * lobe_pdf(k);
  }
  return Pdf<SolidAngle>(sum);
}

void Bsdf::add_other_lobes(int chosen, const Vec3& wo, const Weights& forward,
                           const Weights* reverse, TransportMode mode, LobeSample& s) const {
  const Pair pair{wo, s.wi, 1.F, 1.F, s.transmission, true};
  Spectrum total = s.weight * s.pdf;
  s.pdf *= forward.probability[chosen];
  s.reverse_pdf = reverse != nullptr ? s.reverse_pdf * reverse->probability[chosen] : 0.F;
  for (int k = 0; k < count_; ++k) {
    if (k == chosen) continue;
    const LobeValue v = evaluate(k, pair, mode);
    total += entry(k).scale * v.value;
    s.pdf += forward.probability[k] * v.pdf;
    if (reverse != nullptr) s.reverse_pdf += reverse->probability[k] * v.reverse_pdf;
  }
  s.weight = total / s.pdf;
}

std::optional<int> Bsdf::choose(const Weights& weights, float& u) const {
  int chosen = 0;
  // The last lobe of positive probability covers the rounding at the end of the unit interval.
  int last = count_ - 1;
  while (last > 0 && !(weights.probability[last] > 0.F)) --last;
  while (chosen < last && u >= weights.probability[chosen]) {
    u -= weights.probability[chosen];
    ++chosen;
  }
  if (!(weights.probability[chosen] > 0.F)) return std::nullopt;
  u = std::min(u / weights.probability[chosen], kOneMinusEpsilon);
  return chosen;
}

std::optional<LobeInverse> Bsdf::inverse(const Vec3& wo, const Vec3& wi, float u_lobe,
                                         Inverted lobes) const {
  const Frame shading = frame();
  const float wo_side = dot(wo, ng());
  const Vec3 o = shading.to_local(wo);
  if (!connectible_ || std::abs(wo_side) < kGrazing || std::abs(o.z) < kGrazing) {
    return std::nullopt;
  }
  const Vec3 local_ng = shading.to_local(wo_side > 0.F ? ng() : -ng());
  int chosen = 0;
  if (count_ > 1) {
    const std::optional<int> choice = choose(weights(o), u_lobe);
    if (!choice) return std::nullopt;
    chosen = *choice;
  }
  return visit_lobe(entry(chosen).lobe, [&](const auto& l) -> std::optional<LobeInverse> {
    if constexpr (kIsSpecular<decltype(l)>) {
      return std::nullopt;
    } else {
      if (lobes == Inverted::Diffuse) {
        if constexpr (requires { l.is_diffuse(o, u_lobe); }) {
          if (!l.is_diffuse(o, u_lobe)) return std::nullopt;
        } else {
          return std::nullopt;
        }
      }
      return l.inverse(o, shading.to_local(wi), u_lobe, local_ng);
    }
  });
}

UnitInterval Bsdf::choices(int index, const Weights& weights, const Vec3& wo, const Vec3& wi,
                           bool transmission, float& u) const {
  UnitInterval chosen;
  if (count_ > 1) {
    for (int k = 0; k < index; ++k) chosen.begin += static_cast<double>(weights.probability[k]);
    chosen.size = static_cast<double>(weights.probability[index]);
  }
  return visit_lobe(entry(index).lobe, [&](const auto& l) {
    if constexpr (requires { l.choices(wo, wi, transmission, u); }) {
      return chosen.part(l.choices(wo, wi, transmission, u));
    } else {
      return chosen;
    }
  });
}

std::optional<BsdfUniforms> Bsdf::invert(const Vec3& wo, const Vec3& wi, ScatterEvent event,
                                         const BsdfUniforms& fresh) const {
  const Vec3 o = frame().to_local(wo);
  if (std::abs(dot(wo, ng())) < kGrazing || std::abs(o.z) < kGrazing) return std::nullopt;
  Weights forward{{1.F}};
  if (count_ > 1) forward = weights(o);
  BsdfUniforms u = fresh;
  if (event.specular()) {
    if (event.lobe >= count_ || !is_specular(entry(event.lobe).lobe)) return std::nullopt;
    const UnitInterval numbers =
        choices(event.lobe, forward, o, Vec3(0.F), event.transmission, u.lobe);
    if (!(numbers.size > 0.0)) return std::nullopt;
    u.lobe = numbers.at(u.lobe);
    return u;
  }
  const Pair pair = classify(wo, wi);
  if (!pair.valid || pair.transmission != event.transmission) return std::nullopt;
  std::array<double, kMaxLobes> shares{};
  double sum = 0.0;
  for (int k = 0; k < count_; ++k) {
    shares[k] = static_cast<double>(forward.probability[k]) *
                static_cast<double>(evaluate(k, pair, TransportMode::Radiance).pdf);
    sum += shares[k];
  }
  if (!(sum > 0.0)) return std::nullopt;
  // Any of the lobes can have been the one, in proportion to how often it goes there.
  int chosen = 0;
  for (; chosen + 1 < count_; ++chosen) {
    if (came_first(shares[chosen], sum - shares[chosen], u.lobe)) break;
    sum -= shares[chosen];
  }
  if (!(shares[chosen] > 0.0)) return std::nullopt;
  u.lobe = choices(chosen, forward, pair.wo, pair.wi, pair.transmission, u.lobe).at(u.lobe);
  const std::optional<LobeInverse> direction = inverse(wo, wi, u.lobe, Inverted::Rough);
  if (!direction || !(direction->pdf > 0.F)) return std::nullopt;
  u.direction = direction->direction;
  return u;
}

bool Bsdf::is_uncounted(ScatterEvent event) const {
  if (!event.specular() || !event.transmission || event.lobe >= count_) return false;
  return visit_lobe(entry(event.lobe).lobe, [](const auto& lobe) {
    if constexpr (requires { lobe.uncounted; }) {
      return lobe.uncounted;
    } else {
      return false;
    }
  });
}

std::optional<BsdfSample> Bsdf::specular(const Vec3& wo, ScatterEvent event,
                                         TransportMode mode) const {
  const auto u = invert(wo, Vec3(0.F), event, {0.5F, {0.5F, 0.5F}});
  if (!u) return std::nullopt;
  std::optional<BsdfSample> result = sample(wo, *u, mode);
  if (result && result->event() != event) result.reset();
  return result;
}

std::optional<BsdfSample> Bsdf::sample(const Vec3& wo, const BsdfUniforms& u, TransportMode mode,
                                       Reverse reverse) const {
  const Frame shading = frame();
  const float wo_side = dot(wo, ng());
  const Vec3 o = shading.to_local(wo);
  if (count_ == 0 || std::abs(wo_side) < kGrazing || std::abs(o.z) < kGrazing) return std::nullopt;
  const Vec3 local_ng = shading.to_local(wo_side > 0.F ? ng() : -ng());

  int chosen = 0;
  BsdfUniforms v = u;
  Weights forward;
  if (count_ > 1) {
    forward = weights(o);
    const std::optional<int> choice = choose(forward, v.lobe);
    if (!choice) return std::nullopt;
    chosen = *choice;
  }

  const Entry& e = entry(chosen);
  std::optional<LobeSample> s =
      visit_lobe(e.lobe, [&](const auto& l) { return l.sample(o, v, local_ng, mode); });
  if (!s || std::abs(s->wi.z) < kGrazing) return std::nullopt;
  std::optional<BsdfSample> result(std::in_place);
  result->wi = shading.to_world(s->wi);
  const float wi_side = dot(result->wi, ng());
  if (std::abs(wi_side) < kGrazing || (wo_side * wi_side < 0.F) != s->transmission) {
    return std::nullopt;
  }

  const bool specular = is_specular(e.lobe);
  s->weight *= e.scale;
  if (count_ > 1) {
    Weights backward;
    const Weights* wanted = nullptr;
    if (reverse == Reverse::Compute) {
      backward = weights(s->wi);
      wanted = &backward;
    }
    if (specular) {
      s->weight /= forward.probability[chosen];
      s->pdf *= forward.probability[chosen];
      s->reverse_pdf = wanted != nullptr ? s->reverse_pdf * backward.probability[chosen] : 0.F;
    } else {
      add_other_lobes(chosen, o, forward, wanted, mode, *s);
    }
  }
  if (mode == TransportMode::Importance) {
    s->weight *= std::abs(o.z * wi_side / (wo_side * s->wi.z));
  }
  result->weight = s->weight;
  // Where they belong at once: these are pairs of members that would be written one by one and
  // copied as a whole.
  if (specular) {
    std::construct_at(&result->pdf, Pdf<Discrete>(s->pdf));
    std::construct_at(&result->reverse_pdf, Pdf<Discrete>(s->reverse_pdf));
  } else {
    std::construct_at(&result->pdf, Pdf<SolidAngle>(s->pdf));
    std::construct_at(&result->reverse_pdf, Pdf<SolidAngle>(s->reverse_pdf));
  }
  result->transmission = s->transmission;
  result->lobe = specular ? static_cast<std::int8_t>(chosen) : ScatterEvent::kRough;
  result->eta = s->eta;
  return result;
}

Spectrum Bsdf::albedo(const Vec3& wo) const {
  const Vec3 o = frame().to_local(wo);
  Spectrum sum;
  for (int k = 0; k < count_; ++k) {
    const Entry& e = entry(k);
    sum += e.scale * visit_lobe(e.lobe, [&](const auto& l) { return l.albedo(o); });
  }
  return sum;
}

}  // namespace ajar
