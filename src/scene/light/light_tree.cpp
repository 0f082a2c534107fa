#include "scene/light/light_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace ajar {

namespace {

Vec3 centroid(const LightBounds& bounds) { return (bounds.box.min + bounds.box.max) * 0.5F; }

/// Solid angle into which light goes, each direction weighted by the cosine beyond the cone of
/// normals. Source: Conty Estevez & Kulla 2018, section 4.4, equation 1.
float orientation_measure(const LightBounds& bounds) {
  const float normals = bounds.normals.angle;
  const float all = std::min(normals + bounds.emission_angle, kPi);
  const float measure = 2.F * kPi * (1.F - std::cos(normals)) +
                        0.5F * kPi *
                            (2.F * all * std::sin(normals) - std::cos(normals - 2.F * all) -
                             2.F * normals * std::sin(normals) + std::cos(normals));
  // The narrowest beam still has a size, or it would not matter where it is.
  return std::max(bounds.two_sided ? 2.F * measure : measure, 1e-4F);
}

/// Cost of a node with lights of this power (in place of the intensity). The box enters by the
/// square of its diagonal instead of its surface, because the importance takes it for a sphere and
/// because lights in a row have a box without surface.
float cost(const LightBounds& bounds) {
  return bounds.intensity * orientation_measure(bounds) * length_squared(bounds.box.size());
}

}  // namespace

/// Splits in two by the surface area orientation heuristic, in bins of equal width, and then leaves
/// out every other level, so that four children are compared at once. While a tree is built
/// the bounds hold powers instead of intensities: what adds up, and what a node spreads over all
/// directions of its cone.
class LightTree::Builder {
 public:
  Builder(std::vector<Item>& items, LightTree& tree) : items_(items), tree_(tree) {}

  void build() {
    split_.reserve(2 * items_.size());
    split_.resize(1);
    fill(0, 0, items_.size(), 0);
    tree_.nodes_.reserve(items_.size() / 2 + 1);
    add_node({0}, 0, 0);
  }

 private:
  static constexpr int kBins = 12;
  /// From here on halves are equal, so that trails fit into 64 bits for any number of lights.
  static constexpr int kBalancedDepth = 30;
  static constexpr std::size_t kNone = 0;

  /// A node of the binary tree that comes first.
  struct Part {
    LightBounds bounds;
    std::size_t children = kNone;  ///< the first of two, or kNone
    std::uint32_t light = 0;       ///< index of the light of a leaf
  };
  struct Split {
    float cost = std::numeric_limits<float>::infinity();
    int axis = 0;
    int bin = 0;  ///< the first one of the second half
  };

  void fill(std::size_t part, std::size_t first, std::size_t last, int depth) {
    LightBounds bounds = items_[first].bounds;
    for (std::size_t i = first + 1; i < last; ++i) bounds = unite(bounds, items_[i].bounds);
    if (last - first == 1) {
      split_[part] = {bounds, kNone, items_[first].light};
      return;
    }
    const std::size_t children = split_.size();
    split_[part] = {bounds, children, 0};
    split_.resize(children + 2);
    const std::size_t middle = depth < kBalancedDepth ? split(first, last) : (first + last) / 2;
    fill(children, first, middle, depth + 1);
    fill(children + 1, middle, last, depth + 1);
  }

  /// A node whose children are those of `parts`, or the parts themselves where these are leaves.
  /// Returns its index.
  std::uint32_t add_node(const std::vector<std::size_t>& parts, unsigned bits,
                         std::uint64_t trail) {
    std::vector<std::size_t> children;
    for (const std::size_t part : parts) {
      if (split_[part].children == kNone) {
        children.push_back(part);
      } else {
        children.insert(children.end(), {split_[part].children, split_[part].children + 1});
      }
    }
    const auto index = static_cast<std::uint32_t>(tree_.nodes_.size());
    tree_.nodes_.push_back(empty_node());
    for (std::size_t lane = 0; lane < children.size(); ++lane) {
      const Part part = split_[children[lane]];
      const std::uint64_t child_trail = trail | (std::uint64_t{lane} << bits);
      std::uint32_t link = 0;
      if (part.children == kNone) {
        link = part.light | kLeaf;
        tree_.trails_[part.light] = child_trail;
      } else {
        link = add_node({part.children, part.children + 1}, bits + kTrailBits, child_trail);
      }
      set_lane(tree_.nodes_[index], lane, part.bounds, link);
    }
    return index;
  }

  static Node empty_node() {
    Node node{};
    node.radius_squared = node.radius_squared + 1.F;
    node.cos_normals = node.cos_normals - 1.F;
    return node;
  }

  static void set_lane(Node& node, std::size_t lane, const LightBounds& bounds,
                       std::uint32_t link) {
    const Vec3 center = centroid(bounds);
    for (int i = 0; i < 3; ++i) {
      node.center[i][lane] = center[i];
      node.axis[i][lane] = bounds.normals.axis[i];
    }
    // A little larger, so that it contains the box in spite of roundings. Never zero: importances
    // stay finite.
    const Vec3 half = bounds.box.size() * 0.5F;
    node.radius_squared[lane] = std::max(length_squared(half) * 1.0001F, 1e-30F);
    node.intensity[lane] = bounds.intensity / orientation_measure(bounds);
    const bool whole = bounds.normals.is_whole_sphere();
    node.cos_normals[lane] = whole ? -1.F : std::cos(bounds.normals.angle);
    node.sin_normals[lane] = whole ? 0.F : std::sin(bounds.normals.angle);
    node.cos_emission[lane] = std::cos(bounds.emission_angle);
    node.link[lane] = link | (bounds.two_sided ? kTwoSided : 0U);
  }

  /// Orders the items such that the two halves are on the two sides of the returned index.
  std::size_t split(std::size_t first, std::size_t last) {
    Box3 centers;
    for (std::size_t i = first; i < last; ++i) centers.extendBy(centroid(items_[i].bounds));
    const Vec3 size = centers.size();
    const float longest = std::max({size.x, size.y, size.z});
    const auto bin_of = [&](const Item& item, int axis) {
      const float x = (centroid(item.bounds)[axis] - centers.min[axis]) / size[axis];
      return std::clamp(static_cast<int>(x * kBins), 0, kBins - 1);
    };
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
      if (!(size[axis] > 0.F) || !std::isfinite(size[axis])) continue;
      std::array<LightBounds, kBins> bins;
      for (std::size_t i = first; i < last; ++i) {
        LightBounds& bin = bins[static_cast<std::size_t>(bin_of(items_[i], axis))];
        bin = unite(bin, items_[i].bounds);
      }
      best_of_axis(bins, axis, longest / size[axis], best);
    }
    // All in one place.
    if (best.bin == 0) return (first + last) / 2;
    const auto begin = items_.begin();
    const auto middle = std::partition(
        begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last),
        [&](const Item& i) { return bin_of(i, best.axis) < best.bin; });
    return static_cast<std::size_t>(middle - begin);
  }

  /// `penalty` keeps nodes from becoming thin (K_r of the paper).
  static void best_of_axis(const std::array<LightBounds, kBins>& bins, int axis, float penalty,
                           Split& best) {
    std::array<float, kBins> after{};
    LightBounds sum;
    for (std::size_t b = kBins; b-- > 1;) {
      sum = unite(sum, bins[b]);
      after[b] = sum.normals.is_empty() ? -1.F : cost(sum);
    }
    sum = {};
    for (std::size_t b = 1; b < kBins; ++b) {
      sum = unite(sum, bins[b - 1]);
      if (sum.normals.is_empty() || after[b] < 0.F) continue;
      const float total = penalty * (cost(sum) + after[b]);
      if (total < best.cost) best = {total, axis, static_cast<int>(b)};
    }
  }

  std::vector<Item>& items_;
  std::vector<Part> split_;
  LightTree& tree_;
};

LightTree::LightTree(std::vector<Item> items) {
  if (items.empty()) return;
  std::uint32_t largest = 0;
  for (Item& item : items) {
    largest = std::max(largest, item.light);
    item.bounds.intensity *= orientation_measure(item.bounds);
    power_ += static_cast<double>(item.bounds.intensity);
  }
  // Relative powers, so that neither sums overflow nor products with distances vanish.
  for (Item& item : items) {
    const double relative = static_cast<double>(item.bounds.intensity) / power_;
    item.bounds.intensity =
        std::max(static_cast<float>(relative), std::numeric_limits<float>::min());
  }
  trails_.assign(std::size_t{largest} + 1, kNotInTree);
  Builder(items, *this).build();
}

namespace {
/// The mean of 1 / d² over a cube, seen from its centre, is that of a ball of the same volume: 6
/// over the square of half the diagonal. So this keeps the estimate right in the middle of many
/// lights as well as far away, smooth between, and bounded. (A bound at half the diagonal, as in
/// pbrt-v4, makes nodes around the reference too unlikely by this factor at each level.)
constexpr float kSoftening = 1.F / 6.F;

using Lanes = float __attribute__((vector_size(16)));
using Mask = std::int32_t __attribute__((vector_size(16)));

Lanes square_root(Lanes x) {
  Lanes result;
  for (int i = 0; i < 4; ++i) result[i] = std::sqrt(x[i]);
  return result;
}
Lanes at_least_zero(Lanes x) { return x > 0.F ? x : Lanes{}; }

}  // namespace

LightTree::Lanes LightTree::importance(const Node& node, const Vec3& reference) {
  const Lanes x = reference.x - node.center[0];
  const Lanes y = reference.y - node.center[1];
  const Lanes z = reference.z - node.center[2];
  const Lanes squared = x * x + y * y + z * z;
  const Lanes irradiance = node.intensity / (squared + kSoftening * node.radius_squared);

  // Angles at the node: θ from the axis to the reference, θ_b of half the sphere as seen from
  // there, θ_o of the normals. The least angle to any normal is θ' = max(0, θ − θ_o − θ_b). NaN,
  // from within the sphere, is not used.
  const Lanes inverse_squared = 1.F / squared;
  const Lanes along =
      (x * node.axis[0] + y * node.axis[1] + z * node.axis[2]) * square_root(inverse_squared);
  Mask two_sided;
  std::memcpy(&two_sided, node.link, sizeof(two_sided));
  two_sided = (two_sided & static_cast<std::int32_t>(kTwoSided)) != 0;
  const Lanes cos_theta = (two_sided & (along < 0.F)) ? -along : along;
  const Lanes sin_b_squared = node.radius_squared * inverse_squared;
  const Lanes sin_b = square_root(sin_b_squared);
  const Lanes cos_b = square_root(at_least_zero(1.F - sin_b_squared));
  const Lanes cos_sum = node.cos_normals * cos_b - node.sin_normals * sin_b;
  const Lanes sin_sum = node.sin_normals * cos_b + node.cos_normals * sin_b;
  const Lanes sin_theta = square_root(at_least_zero(1.F - cos_theta * cos_theta));
  const Lanes cosine = cos_theta * cos_sum + sin_theta * sin_sum;

  // Fades to nothing where emission ends: the cosine itself for surfaces, the rim of a spot.
  constexpr float kRounding = 1e-4F;
  const Lanes range = 1.F - node.cos_emission + kRounding;
  const Lanes faded = irradiance * at_least_zero(cosine - node.cos_emission + kRounding) / range;
  // Within its sphere a node says nothing of directions.
  const Mask everywhere = (squared <= node.radius_squared) | (node.cos_normals <= -1.F) |
                          (sin_sum < 0.F) | (cos_theta >= cos_sum);
  return everywhere ? irradiance : faded;
}

LightTree::Lanes LightTree::shares(const Node& node, const Vec3& reference) {
  const auto sum = [](Lanes x) { return (x[0] + x[1]) + (x[2] + x[3]); };
  Lanes weights = importance(node, reference);
  // The bounds above were too loose if no light below reaches the reference.
  if (!(sum(weights) > 0.F)) weights = node.intensity;
  // Nonzero probabilities stay nonzero although uniform numbers are rounded.
  const Lanes least = (Lanes{} + 0x1p-22F) * sum(weights);
  weights = ((weights > 0.F) & (weights < least)) ? least : weights;
  return weights / sum(weights);
}

LightTree::Choice LightTree::choose(const Vec3& reference, float u) const {
  float probability = 1.F;
  std::uint32_t link = 0;
  while ((link & kLeaf) == 0) {
    const Node& node = nodes_[link & kIndex];
    const Lanes share = shares(node, reference);
    // The last child that starts before u.
    int chosen = 0;
    float start = 0.F;
    float end = 0.F;
    for (int i = 0; i < kWidth; ++i) {
      if (share[i] > 0.F && end <= u) {
        chosen = i;
        start = end;
      }
      end += share[i];
    }
    probability *= share[chosen];
    u = std::min((u - start) / share[chosen], kOneMinusEpsilon);
    link = node.link[chosen];
  }
  return {link & kIndex, probability, u};
}

float LightTree::probability(const Vec3& reference, std::uint32_t light) const {
  if (light >= trails_.size() || trails_[light] == kNotInTree) return 0.F;
  std::uint64_t trail = trails_[light];
  float probability = 1.F;
  std::uint32_t link = 0;
  while ((link & kLeaf) == 0) {
    const Node& node = nodes_[link & kIndex];
    const auto child = static_cast<int>(trail % kWidth);
    probability *= shares(node, reference)[child];
    trail >>= kTrailBits;
    link = node.link[child];
  }
  return probability;
}

UnitInterval LightTree::interval(const Vec3& reference, std::uint32_t light) const {
  std::uint64_t trail = trails_[light];
  UnitInterval numbers;
  std::uint32_t link = 0;
  while ((link & kLeaf) == 0) {
    const Node& node = nodes_[link & kIndex];
    const auto child = static_cast<int>(trail % kWidth);
    const Lanes share = shares(node, reference);
    float start = 0.F;
    for (int i = 0; i < child; ++i) start += share[i];
    numbers = numbers.part({static_cast<double>(start), static_cast<double>(share[child])});
    trail >>= kTrailBits;
    link = node.link[child];
  }
  return numbers;
}

double LightTree::irradiance(const Vec3& reference) const {
  const Lanes estimates = importance(nodes_.front(), reference);
  return power_ *
         static_cast<double>((estimates[0] + estimates[1]) + (estimates[2] + estimates[3]));
}

}  // namespace ajar
