#include "scene/bsdf/coat.h"

#include <array>
#include <cmath>

namespace ajar {
namespace {

// Nodes of the table; between them everything is linear.
constexpr std::array kIndices = {1.F, 1.05F, 1.15F, 1.3F, 1.5F, 1.75F, 2.F, 2.5F, 3.F, 4.F};
constexpr std::array kAlphas = {0.F, 0.05F, 0.1F, 0.2F, 0.3F, 0.45F, 0.6F, 0.8F, 1.F};
constexpr int kCosines =
    33;  ///< squares of evenly spaced numbers: grazing angles are the steep ones

float cosine_of(int node) {
  const float root = static_cast<float>(node) / (kCosines - 1);
  return std::max(root * root, 1e-4F);
}

/// Directional albedo of a rough coat, by midpoints of its own sampling.
float reflected(float eta, float alpha, float cosine) {
  if (alpha == 0.F) return fresnel_dielectric(cosine, eta).reflectance;
  constexpr int kPoints = 24;
  const RoughCoat coat{{FacetModel::Ggx, alpha, alpha}, {eta}};
  const Vec3 wo(std::sqrt(1.F - cosine * cosine), 0.F, cosine);
  double sum = 0.0;
  for (int y = 0; y < kPoints; ++y) {
    for (int x = 0; x < kPoints; ++x) {
      const Vec2 u((static_cast<float>(x) + 0.5F) / kPoints,
                   (static_cast<float>(y) + 0.5F) / kPoints);
      const auto s = coat.sample(wo, {0.F, u}, Vec3(0.F, 0.F, 1.F), TransportMode::Radiance);
      if (s) sum += static_cast<double>(s->weight[0]);
    }
  }
  return static_cast<float>(sum / (kPoints * kPoints));
}

struct Place {
  std::size_t node;
  float fraction;
};
template <std::size_t Size>
Place place_of(const std::array<float, Size>& nodes, float value) {
  std::size_t node = 0;
  while (node + 2 < Size && value >= nodes[node + 1]) ++node;
  const float fraction = (value - nodes[node]) / (nodes[node + 1] - nodes[node]);
  return {node, std::clamp(fraction, 0.F, 1.F)};
}

float lerp(float a, float b, float t) { return a + (b - a) * t; }

class CoatTable {
 public:
  CoatTable() {
    for (std::size_t e = 0; e < kIndices.size(); ++e) {
      for (std::size_t a = 0; a < kAlphas.size(); ++a) {
        auto& row = transmitted_[e][a];
        for (int c = 0; c < kCosines; ++c) {
          row[static_cast<std::size_t>(c)] = 1.F - reflected(kIndices[e], kAlphas[a], cosine_of(c));
        }
        // ∫ T 2μ dμ with μ = t², dμ = 2t dt, by midpoints.
        constexpr int kPoints = 256;
        double sum = 0.0;
        for (int i = 0; i < kPoints; ++i) {
          const float t = (static_cast<float>(i) + 0.5F) / kPoints;
          sum += static_cast<double>(at(row, t) * 4.F * t * t * t);
        }
        mean_[e][a] = static_cast<float>(sum / kPoints);
      }
    }
  }

  float transmittance(float eta, float alpha, float cosine) const {
    const float root = std::sqrt(std::min(cosine, 1.F));
    return interpolate(eta, alpha,
                       [&](std::size_t e, std::size_t a) { return at(transmitted_[e][a], root); });
  }
  float mean(float eta, float alpha) const {
    return interpolate(eta, alpha, [&](std::size_t e, std::size_t a) { return mean_[e][a]; });
  }

 private:
  using Row = std::array<float, kCosines>;
  static float at(const Row& row, float root) {
    const float x = root * (kCosines - 1);
    const auto node = std::min(static_cast<std::size_t>(x), row.size() - 2);
    return lerp(row[node], row[node + 1], x - static_cast<float>(node));
  }
  template <typename Value>
  static float interpolate(float eta, float alpha, const Value& value) {
    const Place e = place_of(kIndices, eta);
    const Place a = place_of(kAlphas, alpha);
    return lerp(lerp(value(e.node, a.node), value(e.node, a.node + 1), a.fraction),
                lerp(value(e.node + 1, a.node), value(e.node + 1, a.node + 1), a.fraction),
                e.fraction);
  }

  std::array<std::array<Row, kAlphas.size()>, kIndices.size()> transmitted_{};
  std::array<std::array<float, kAlphas.size()>, kIndices.size()> mean_{};
};

const CoatTable& table() {
  static const CoatTable kTable;
  return kTable;
}

/// ∫ F 2μ dμ of a smooth boundary seen from its thinner side, eta > 1. Source: Walsh 1926, "The
/// reflection factor of a polished glass surface for diffused light".
double diffuse_reflectance(double eta) {
  if (!(eta > 1.0 + 1e-4)) return 0.0;
  const double n2 = eta * eta;
  const double n4 = n2 * n2;
  return 0.5 + (eta - 1.0) * (3.0 * eta + 1.0) / (6.0 * (eta + 1.0) * (eta + 1.0)) +
         n2 * (n2 - 1.0) * (n2 - 1.0) / ((n2 + 1.0) * (n2 + 1.0) * (n2 + 1.0)) *
             std::log((eta - 1.0) / (eta + 1.0)) -
         2.0 * n2 * eta * (n2 + 2.0 * eta - 1.0) / ((n2 + 1.0) * (n4 - 1.0)) +
         8.0 * n4 * (n4 + 1.0) / ((n2 + 1.0) * (n4 - 1.0) * (n4 - 1.0)) * std::log(eta);
}

/// What is left of diffuse light on one way through a layer of this optical thickness x:
/// ∫ exp(−x/μ) 2μ dμ = (1 − x) exp(−x) + x² E₁(x).
float mean_left(float thickness) {
  if (!(thickness > 0.F)) return 1.F;
  const auto x = static_cast<double>(std::min(thickness, 80.F));
  return static_cast<float>((1.0 - x) * std::exp(-x) - x * x * std::expint(-x));
}

}  // namespace

float Coat::transmittance(float cosine) const {
  if (alpha > 0.F) return table().transmittance(eta, alpha, cosine);
  return 1.F - fresnel_dielectric(std::min(cosine, 1.F), eta).reflectance;
}

float Coat::mean_transmittance() const {
  if (alpha > 0.F) return table().mean(eta, alpha);
  return static_cast<float>(1.0 - diffuse_reflectance(static_cast<double>(eta)));
}

CoatedDiffuse::CoatedDiffuse(const Spectrum& reflectance, const Coat& above,
                             const CoatInside& inside)
    : coat(above), depth(inside.depth) {
  // By reciprocity the coat lets through 1 − F = mean transmittance / η² of diffuse light inside.
  const float squared = above.eta * above.eta;
  const float turned_back = 1.F - above.mean_transmittance() / squared;
  const auto lane = [&](float r, float thickness) {
    const float left = mean_left(thickness);
    const float x = r * turned_back * left * left;
    const float bounces =
        inside.bounces > 0 ? 1.F - std::pow(x, static_cast<float>(inside.bounces)) : 1.F;
    return r * bounces / (squared * std::max(1.F - x, 1e-6F));
  };
  const Spectrum& d = inside.depth;
  base = PackedSpectrum(
      {lane(reflectance[0], d[0]), lane(reflectance[1], d[1]), lane(reflectance[2], d[2])});
}

}  // namespace ajar
