#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/unit_interval.h"
#include "scene/light/light_bounds.h"

namespace ajar {

/// Chooses among lights at finite places in proportion to an estimate of their light at a point: a
/// tree of bounds, descended at random by the importance of the children. Every light that can
/// reach the point can be chosen, but for roundings. Immutable; choosing takes O(depth), without
/// recursion. Source: Conty Estevez & Kulla 2018, "Importance sampling of many lights with adaptive
/// tree splitting"; the importance follows pbrt-v4, section 12.6.3, for points without normal.
class LightTree {
 public:
  static constexpr int kWidth = 4;

  struct Item {
    LightBounds bounds;   ///< intensity finite and > 0
    std::uint32_t light;  ///< the number by which it is chosen
  };
  struct Choice {
    std::uint32_t light;
    float probability;  ///< > 0
    float u;            ///< the uniform number, stretched to [0, 1) again
  };

  LightTree() = default;
  explicit LightTree(std::vector<Item> items);
  bool empty() const { return nodes_.empty(); }
  /// Requires !empty().
  Choice choose(const Vec3& reference, float u) const;
  /// Bit for bit that of `choose`; 0 for lights that are not in the tree.
  float probability(const Vec3& reference, std::uint32_t light) const;
  /// The numbers by which `choose` gives this light, of probability > 0.
  UnitInterval interval(const Vec3& reference, std::uint32_t light) const;
  /// Estimate of the irradiance at `reference` on a surface that faces the lights, without
  /// shadows: luminance, W/m². Requires !empty().
  double irradiance(const Vec3& reference) const;

 private:
  using Lanes = float __attribute__((vector_size(16)));

  /// Bounds of up to four children, one per lane, in three cache lines. Missing children have no
  /// intensity.
  struct alignas(64) Node {
    Lanes center[3];       ///< centres of spheres around the boxes
    Lanes radius_squared;  ///< squared radii of these spheres: half the diagonals of the boxes
    Lanes axis[3];         ///< mean axis of the normals
    Lanes intensity;       ///< mean over the directions it shines in, per power of the whole tree
    Lanes cos_normals;     ///< −1 for the whole sphere
    Lanes sin_normals;
    Lanes cos_emission;
    std::uint32_t link[kWidth];  ///< light of a leaf or index of a node, kLeaf, kTwoSided
  };
  static constexpr std::uint32_t kLeaf = 1U << 31U;
  static constexpr std::uint32_t kTwoSided = 1U << 30U;
  static constexpr std::uint32_t kIndex = kTwoSided - 1;
  static constexpr std::uint64_t kNotInTree = ~std::uint64_t{0};
  static constexpr unsigned kTrailBits = 2;  ///< per level

  class Builder;

  static Lanes importance(const Node& node, const Vec3& reference);
  /// Probabilities of the children.
  static Lanes shares(const Node& node, const Vec3& reference);

  std::vector<Node> nodes_;  ///< the root first
  /// By light: which child to take, from the lowest bits on.
  std::vector<std::uint64_t> trails_;
  double power_ = 0.0;  ///< power of all lights, W
};

}  // namespace ajar
