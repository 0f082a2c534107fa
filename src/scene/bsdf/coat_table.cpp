#include "scene/bsdf/coat_table.h"

#include <array>
#include <cmath>
#include <vector>

#include "scene/bsdf/fresnel.h"

namespace ajar::coat_table {
namespace {

// Nodes of the table; between them everything is linear.
constexpr std::array kIndices = {1.F, 1.05F, 1.15F, 1.3F, 1.4F, 1.5F, 1.6F, 1.75F,
                                 2.F, 2.5F,  3.F,   4.F,  6.F,  10.F, 20.F};
constexpr std::array kAlphas = {0.F,  0.0125F, 0.025F, 0.05F, 0.075F, 0.1F, 0.15F, 0.2F, 0.25F,
                                0.3F, 0.35F,   0.4F,   0.5F,  0.6F,   0.7F, 0.8F,  0.9F, 1.F};
constexpr int kCosines =
    33;  ///< squares of evenly spaced numbers: grazing angles are the steep ones
constexpr int kCosinesInside = 64;  ///< evenly spaced

float cosine_of(int node) {
  const float root = static_cast<float>(node) / (kCosines - 1);
  return std::max(root * root, 1e-4F);
}
float cosine_inside(int node) {
  return std::max(static_cast<float>(node) / (kCosinesInside - 1), 1e-4F);
}

/// A normal of facets, and the area of its cell.
struct Facet {
  Vec3 normal;
  float area;
};

/// Midpoints of the distribution D cos θ, over half a turn: the other half is its mirror image. The
/// cumulative distribution is 1 − v², so that the long tails of GGX have enough of them.
std::vector<Facet> facets_of(FacetModel model, float alpha, int rings, int turns) {
  const bool is_beckmann = model == FacetModel::Beckmann || model == FacetModel::BeckmannSeparable;
  std::vector<Facet> facets;
  for (int y = 0; y < rings; ++y) {
    const double v = (y + 0.5) / rings;
    const double slope = static_cast<double>(alpha) *
                         std::sqrt(is_beckmann ? -2.0 * std::log(v) : (1.0 - v * v) / (v * v));
    const double z = 1.0 / std::sqrt(1.0 + slope * slope);
    for (int x = 0; x < turns; ++x) {
      const double phi = M_PI * (x + 0.5) / turns;
      const Vec3 normal(static_cast<float>(slope * z * std::cos(phi)),
                        static_cast<float>(slope * z * std::sin(phi)), static_cast<float>(z));
      facets.push_back({normal, static_cast<float>(v / z)});
    }
  }
  return facets;
}

/// Facets as seen from one direction.
class VisibleFacets {
 public:
  VisibleFacets(FacetModel model, float alpha, float cosine, const std::vector<Facet>& all)
      : facets_(model, alpha, alpha), wo_(std::sqrt(1.F - cosine * cosine), 0.F, cosine) {
    double area = 0.0;
    for (const Facet& facet : all) {
      const float seen = facet.area * dot(wo_, facet.normal);
      if (!(seen > 0.F)) continue;
      area += static_cast<double>(seen);
      const float cosine_h = std::min(dot(wo_, facet.normal), 1.F);
      const Vec3 mirrored = facet.normal * (2.F * cosine_h) - wo_;
      visible_.push_back({facet.normal, cosine_h, seen, left(mirrored, 1.F)});
    }
    share_ = area > 0.0 ? 1.0 / area : 0.0;
  }

  /// Share that facets reflect, into the medium that they are seen from. `eta` is the index of the
  /// other relative to that.
  float reflected(float eta) const {
    double sum = 0.0;
    for (const Visible& facet : visible_) {
      const float reflectance = fresnel_dielectric(facet.cosine, eta).reflectance;
      sum += static_cast<double>(facet.area * reflectance * facet.mirrored);
    }
    return static_cast<float>(sum * share_);
  }
  /// Share that they refract.
  float refracted(float eta) const {
    double sum = 0.0;
    for (const Visible& facet : visible_) {
      const DielectricBoundary boundary = fresnel_dielectric(facet.cosine, eta);
      const Vec3 wi = facet.normal * (facet.cosine / eta - boundary.cos_t) - wo_ / eta;
      sum += static_cast<double>(facet.area * (1.F - boundary.reflectance) * left(wi, -1.F));
    }
    return static_cast<float>(sum * share_);
  }

  /// Share that facets reflect all in all, and to where a smooth boundary of this index above them
  /// turns it back.
  float mirrored() const {
    double sum = 0.0;
    for (const Visible& facet : visible_) sum += static_cast<double>(facet.area * facet.mirrored);
    return static_cast<float>(sum * share_);
  }
  float turned_back(float eta) const {
    double sum = 0.0;
    for (const Visible& facet : visible_) {
      const float cosine = facet.normal.z * 2.F * facet.cosine - wo_.z;
      if (!(facet.mirrored > 0.F)) continue;
      const float reflectance = fresnel_dielectric(std::min(cosine, 1.F), 1.F / eta).reflectance;
      sum += static_cast<double>(facet.area * facet.mirrored * reflectance);
    }
    return static_cast<float>(sum * share_);
  }

 private:
  /// G2 / G1 of light that leaves a facet this way, 0 on the wrong side.
  float left(const Vec3& wi, float side) const {
    if (!(wi.z * side > kGrazing)) return 0.F;
    const float cos_i = std::abs(wi.z);
    const float area_o = facets_.projected_area(wo_);
    return facets_.shadowing_over_cosines(wo_.z, area_o, cos_i, facets_.projected_area(wi)) *
           area_o * cos_i;
  }

  struct Visible {
    Vec3 normal;
    float cosine;    ///< to `wo_`
    float area;      ///< projected area visible from `wo_`
    float mirrored;  ///< unmasked share of its reflection
  };

  Microfacets facets_;
  Vec3 wo_;
  std::vector<Visible> visible_;
  double share_ = 0.0;
};

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

using Row = std::array<float, kCosines>;
template <typename Value>
using Grid = std::array<std::array<Value, kAlphas.size()>, kIndices.size()>;

float at_root(const Row& row, float root) {
  const float x = root * (kCosines - 1);
  const auto node = std::min(static_cast<std::size_t>(x), row.size() - 2);
  return lerp(row[node], row[node + 1], x - static_cast<float>(node));
}
/// ∫ row 2μ dμ with μ = t², dμ = 2t dt, by midpoints.
float mean(const Row& row) {
  constexpr int kPoints = 256;
  double sum = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    const float t = (static_cast<float>(i) + 0.5F) / kPoints;
    sum += static_cast<double>(at_root(row, t) * 4.F * t * t * t);
  }
  return static_cast<float>(sum / kPoints);
}

template <typename Value>
float interpolate(const RoughBoundary& b, const Value& value) {
  const Place e = place_of(kIndices, b.eta);
  const Place a = place_of(kAlphas, b.alpha);
  return lerp(lerp(value(e.node, a.node), value(e.node, a.node + 1), a.fraction),
              lerp(value(e.node + 1, a.node), value(e.node + 1, a.node + 1), a.fraction),
              e.fraction);
}
float at(const Grid<float>& grid, const RoughBoundary& b) {
  return interpolate(b, [&](std::size_t e, std::size_t a) { return grid[e][a]; });
}
float at(const Grid<Row>& grid, const RoughBoundary& b, float cosine) {
  const float root = std::sqrt(std::min(cosine, 1.F));
  return interpolate(b, [&](std::size_t e, std::size_t a) { return at_root(grid[e][a], root); });
}

/// A rough boundary of one model of facets.
class BoundaryTable {
 public:
  explicit BoundaryTable(FacetModel model) {
    for (std::size_t a = 0; a < kAlphas.size(); ++a) {
      fill_outside(model, a);
      fill_inside(model, a);
    }
  }

  float reflected(const RoughBoundary& b, float cosine) const { return at(reflected_, b, cosine); }
  float refracted(const RoughBoundary& b, float cosine) const { return at(refracted_, b, cosine); }
  float mean_reflected(const RoughBoundary& b) const { return at(mean_reflected_, b); }
  float mean_refracted(const RoughBoundary& b) const { return at(mean_refracted_, b); }
  float mean_inside(const RoughBoundary& b) const { return at(mean_inside_, b); }
  float sum_inside(const RoughBoundary& b) const { return at(sum_inside_, b); }

 private:
  void fill_outside(FacetModel model, std::size_t a) {
    const std::vector<Facet> all = facets_of(model, kAlphas[a], 24, 24);
    for (int c = 0; c < kCosines; ++c) {
      const auto node = static_cast<std::size_t>(c);
      const VisibleFacets facets(model, kAlphas[a], cosine_of(c), all);
      for (std::size_t e = 0; e < kIndices.size(); ++e) {
        const float smooth = fresnel_dielectric(cosine_of(c), kIndices[e]).reflectance;
        const bool is_rough = kAlphas[a] > 0.F;
        reflected_[e][a][node] = is_rough ? facets.reflected(kIndices[e]) : smooth;
        refracted_[e][a][node] = is_rough ? facets.refracted(kIndices[e]) : 1.F - smooth;
      }
    }
    for (std::size_t e = 0; e < kIndices.size(); ++e) {
      mean_reflected_[e][a] = mean(reflected_[e][a]);
      mean_refracted_[e][a] = mean(refracted_[e][a]);
    }
  }

  void fill_inside(FacetModel model, std::size_t a) {
    const std::vector<Facet> all = facets_of(model, kAlphas[a], 16, 16);
    std::array<double, kIndices.size()> sums{};
    std::array<double, kIndices.size()> along_normal{};
    for (int c = 0; c < kCosinesInside; ++c) {
      const float cosine = cosine_inside(c);
      const VisibleFacets facets(model, kAlphas[a], cosine, all);
      for (std::size_t e = 0; e < kIndices.size(); ++e) {
        const double share = kAlphas[a] > 0.F
                                 ? facets.reflected(1.F / kIndices[e])
                                 : fresnel_dielectric(cosine, 1.F / kIndices[e]).reflectance;
        sums[e] += share * static_cast<double>(cosine);
        along_normal[e] = share;  // share of the last one
      }
    }
    for (std::size_t e = 0; e < kIndices.size(); ++e) {
      sum_inside_[e][a] = static_cast<float>(2.0 * sums[e] / kCosinesInside);
      // The trapezoidal rule.
      mean_inside_[e][a] =
          static_cast<float>(2.0 * (sums[e] - 0.5 * along_normal[e]) / (kCosinesInside - 1));
    }
  }

  Grid<Row> reflected_{};
  Grid<Row> refracted_{};
  Grid<float> mean_reflected_{};
  Grid<float> mean_refracted_{};
  Grid<float> mean_inside_{};
  Grid<float> sum_inside_{};
};

/// Rough mirrors of one model of facets below a smooth boundary.
class MirrorTable {
 public:
  explicit MirrorTable(FacetModel model) {
    for (std::size_t a = 0; a < kAlphas.size(); ++a) {
      const std::vector<Facet> all = facets_of(model, std::max(kAlphas[a], 1e-3F), 48, 8);
      for (std::size_t e = 0; e < kIndices.size(); ++e) {
        const float eta = kIndices[e];
        for (int c = 0; c < kCosines; ++c) {
          const DielectricBoundary boundary = fresnel_dielectric(cosine_of(c), eta);
          const VisibleFacets facets(model, std::max(kAlphas[a], 1e-3F),
                                     std::max(boundary.cos_t, 1e-4F), all);
          const float by_smooth_ones = facets.mirrored() * boundary.reflectance;
          returned_[e][a][static_cast<std::size_t>(c)] =
              (1.F - boundary.reflectance) *
              std::max(facets.turned_back(eta) - by_smooth_ones, 0.F);
        }
        mean_[e][a] = mean(returned_[e][a]);
      }
      fill_diffuse(model, a, all);
    }
  }

  float returned(const RoughBoundary& b, float cosine) const { return at(returned_, b, cosine); }
  float mean_returned(const RoughBoundary& b) const { return at(mean_, b); }
  DiffuseBelow diffuse(const RoughBoundary& b) const { return {at(leaves_, b), at(returns_, b)}; }

 private:
  void fill_diffuse(FacetModel model, std::size_t a, const std::vector<Facet>& all) {
    for (int c = 0; c < kCosinesInside; ++c) {
      // Midpoints of the cosine's square.
      const float cosine = std::sqrt((static_cast<float>(c) + 0.5F) / kCosinesInside);
      const VisibleFacets facets(model, std::max(kAlphas[a], 1e-3F), cosine, all);
      for (std::size_t e = 0; e < kIndices.size(); ++e) {
        const float returns = facets.turned_back(kIndices[e]);
        returns_[e][a] += returns / kCosinesInside;
        leaves_[e][a] += (facets.mirrored() - returns) / kCosinesInside;
      }
    }
  }

  Grid<Row> returned_{};
  Grid<float> mean_{};
  Grid<float> leaves_{};
  Grid<float> returns_{};
};

template <typename Kind, FacetModel model>
const Kind& table_of_model() {
  static const Kind kTable(model);
  return kTable;
}
/// Made where it is first looked at.
template <typename Kind>
const Kind& table(const RoughBoundary& boundary) {
  switch (boundary.model) {
    case FacetModel::GgxSeparable:
      return table_of_model<Kind, FacetModel::GgxSeparable>();
    case FacetModel::Beckmann:
      return table_of_model<Kind, FacetModel::Beckmann>();
    case FacetModel::BeckmannSeparable:
      return table_of_model<Kind, FacetModel::BeckmannSeparable>();
    case FacetModel::Ggx:
      break;
  }
  return table_of_model<Kind, FacetModel::Ggx>();
}

}  // namespace

float reflected(const RoughBoundary& boundary, float cosine) {
  return table<BoundaryTable>(boundary).reflected(boundary, cosine);
}
float refracted(const RoughBoundary& boundary, float cosine) {
  return table<BoundaryTable>(boundary).refracted(boundary, cosine);
}
float mean_reflected(const RoughBoundary& boundary) {
  return table<BoundaryTable>(boundary).mean_reflected(boundary);
}
float mean_refracted(const RoughBoundary& boundary) {
  return table<BoundaryTable>(boundary).mean_refracted(boundary);
}
float mean_reflected_inside(const RoughBoundary& boundary) {
  return table<BoundaryTable>(boundary).mean_inside(boundary);
}
float sum_reflected_inside(const RoughBoundary& boundary) {
  return table<BoundaryTable>(boundary).sum_inside(boundary);
}

float returned(const RoughBoundary& below, float cosine) {
  return table<MirrorTable>(below).returned(below, cosine);
}
float mean_returned(const RoughBoundary& below) {
  return table<MirrorTable>(below).mean_returned(below);
}
DiffuseBelow diffuse_below(const RoughBoundary& below) {
  return table<MirrorTable>(below).diffuse(below);
}

}  // namespace ajar::coat_table
