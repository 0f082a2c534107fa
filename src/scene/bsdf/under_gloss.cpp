#include "scene/bsdf/under_gloss.h"

#include <array>
#include <cmath>

#include "scene/bsdf/disney_specular.h"

namespace ajar {
namespace {

constexpr int kGlossCosines = 33;
using GlossRow = std::array<float, kGlossCosines>;

/// Place of a number from 0 to 1 among `Nodes` that are evenly spaced.
template <int Nodes>
struct Between {
  std::size_t node;
  float fraction;
  explicit Between(float x) {
    const float place = x > 0.F ? std::min(x, 1.F) * (Nodes - 1) : 0.F;
    node = static_cast<std::size_t>(std::min(static_cast<int>(place), Nodes - 2));
    fraction = place - static_cast<float>(node);
  }
  template <typename Value>
  float mix(const Value& value) const {
    const float first = value(node);
    return first + (value(node + 1) - first) * fraction;
  }
};
template <int Nodes>
constexpr float part(int node) {
  return static_cast<float>(node) / (Nodes - 1);
}

// Nodes are dense where the function is steep: cosine near 0, α near 0, index near 1: they
// are evenly spaced in the root of the first two, and in the fourth root of R0.
float gloss_cosine(int node) {
  return std::max(part<kGlossCosines>(node) * part<kGlossCosines>(node), 1e-4F);
}
Between<kGlossCosines> place_of_cosine(float cosine) {
  return Between<kGlossCosines>(std::sqrt(cosine));
}

/// ∫ … |cos θ_i| dω_i / π of a function of the cosine at the half vector.
template <typename Function>
float mean_at_half_vectors(float cosine, const Function& function) {
  const Vec3 wo(std::sqrt(1.F - cosine * cosine), 0.F, cosine);
  constexpr int kPoints = 24;
  double sum = 0.0;
  for (int y = 0; y < kPoints; ++y) {
    for (int x = 0; x < kPoints; ++x) {
      const Vec3 wi = warp::cosine_hemisphere(
          {(static_cast<float>(x) + 0.5F) / kPoints, (static_cast<float>(y) + 0.5F) / kPoints});
      sum += static_cast<double>(function(half_vector(wo, wi).cosine));
    }
  }
  return static_cast<float>(sum / (kPoints * kPoints));
}

/// Directional albedo of a gloss, by midpoints of its own sampling.
float gloss_albedo(float eta, float alpha, float cosine) {
  if (alpha == 0.F) return fresnel_dielectric(cosine, eta).reflectance;
  const DisneySpecular gloss{{FacetModel::GgxSeparable, alpha, alpha}, {{}, 0.F, eta}};
  const Vec3 wo(std::sqrt(1.F - cosine * cosine), 0.F, cosine);
  constexpr int kPoints = 16;
  double sum = 0.0;
  for (int y = 0; y < kPoints; ++y) {
    for (int x = 0; x < kPoints; ++x) {
      const Vec2 u((static_cast<float>(x) + 0.5F) / kPoints,
                   (static_cast<float>(y) + 0.5F) / kPoints);
      const auto s = gloss.sample(wo, {0.F, u}, Vec3(0.F, 0.F, 1.F), TransportMode::Radiance);
      if (s) sum += static_cast<double>(s->weight[0]);
    }
  }
  return static_cast<float>(sum / (kPoints * kPoints));
}

/// `Gloss::taken` at full strength, and its means.
class TakenTable {
 public:
  TakenTable() {
    for (int e = 0; e < kIndices; ++e) {
      GlossRow fresnel;
      for (int c = 0; c < kGlossCosines; ++c) {
        fresnel[static_cast<std::size_t>(c)] = mean_at_half_vectors(
            gloss_cosine(c),
            [&](float cos_d) { return fresnel_dielectric(cos_d, index_of(e)).reflectance; });
      }
      for (int r = 0; r < kRoughnesses; ++r) {
        Entry& entry = entries_[static_cast<std::size_t>(e)][static_cast<std::size_t>(r)];
        const float roughness = part<kRoughnesses>(r);
        for (int c = 0; c < kGlossCosines; ++c) {
          const auto node = static_cast<std::size_t>(c);
          entry.taken[node] = std::max(
              fresnel[node], gloss_albedo(index_of(e), roughness * roughness, gloss_cosine(c)));
        }
        // ∫ a 2μ dμ with μ = t², dμ = 2t dt, by midpoints.
        constexpr int kPoints = 256;
        double sum = 0.0;
        for (int i = 0; i < kPoints; ++i) {
          const float t = (static_cast<float>(i) + 0.5F) / kPoints;
          sum += static_cast<double>(at(entry, place_of_cosine(t * t)) * 4.F * t * t * t);
        }
        entry.mean = static_cast<float>(sum / kPoints);
      }
    }
  }

  float taken(const Gloss& gloss, float cosine) const {
    const Between<kGlossCosines> place = place_of_cosine(cosine);
    return interpolate(gloss, [&](const Entry& entry) { return at(entry, place); });
  }
  float mean(const Gloss& gloss) const {
    return interpolate(gloss, [](const Entry& entry) { return entry.mean; });
  }

 private:
  static constexpr int kIndices = 25;
  static constexpr int kRoughnesses = 17;
  struct Entry {
    GlossRow taken;
    float mean;
  };

  static float index_of(int node) {
    constexpr float kLargest = 20.F;
    const float root = part<kIndices>(node) * part<kIndices>(node);
    return std::min((1.F + root) / std::max(1.F - root, 1e-3F), kLargest);
  }
  static float at(const Entry& entry, const Between<kGlossCosines>& place) {
    return place.mix([&](std::size_t node) { return entry.taken[node]; });
  }
  template <typename Value>
  float interpolate(const Gloss& gloss, const Value& value) const {
    const Between<kIndices> e(std::sqrt(std::max(0.F, gloss.eta - 1.F) / (gloss.eta + 1.F)));
    const Between<kRoughnesses> r(std::sqrt(gloss.alpha));
    return e.mix([&](std::size_t index) {
      return r.mix([&](std::size_t roughness) { return value(entries_[index][roughness]); });
    });
  }

  std::array<std::array<Entry, kRoughnesses>, kIndices> entries_;
};

const TakenTable& taken_table() {
  static const TakenTable kTable;
  return kTable;
}

}  // namespace

float mean_schlick_weight(float cosine) {
  static const GlossRow kRow = [] {
    GlossRow row;
    for (int c = 0; c < kGlossCosines; ++c) {
      row[static_cast<std::size_t>(c)] = mean_at_half_vectors(gloss_cosine(c), schlick_weight);
    }
    return row;
  }();
  return place_of_cosine(cosine).mix([&](std::size_t node) { return kRow[node]; });
}

float Gloss::taken(float cosine) const { return strength * taken_table().taken(*this, cosine); }
float Gloss::mean_taken() const { return strength * taken_table().mean(*this); }

}  // namespace ajar
