#pragma once
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "path/offset_normal.h"

namespace ajar {

/// Where a specular chain starts, or ends: a point, or a direction at infinity.
struct ChainEnd {
  Vec3d p{0.0};       ///< unless it is at infinity
  Vec3d toward{0.0};  ///< at infinity: unit, from the scene
  bool at_infinity = false;
};
/// End of a chain at vertex `x` < k of a path.
ChainEnd chain_end(const Path& path, int x);

/// True if a vertex may be part of a chain: not in a medium, with a textured index of refraction,
/// or specular with a bump or a normal map.
bool can_hold(const InnerVertex& vertex);

/// A specular chain a, s₁ … sₙ, b, to first order: how its vertices move with its end b while a
/// stays. Each vertex holds the constraint that its generalised half vector η_a ω_a + η_b ω_b has
/// no part across the shading normal (events that go straight on: that it vanishes); of the
/// constraints the derivatives by the vertices are block-tridiagonal. Rough vertices may be among
/// them: these hold their offset normal, which turns with the surface, in place of the shading
/// normal. Source: Jakob & Marschner 2012, "Manifold exploration", section 4; half vectors that are
/// not normalised, and straight events, are ours.
class SpecularChain {
 public:
  explicit SpecularChain(const Scene& scene) : scene_(scene) {}

  /// `vertices` in the order from `start`, with the offset normals of those that are rough; none if
  /// all are specular. False if some vertex cannot hold its constraint (`can_hold`), is not smooth
  /// (`Scene::derivatives`), has no such event, or if the chain is singular: at the borders of
  /// caustics.
  bool set(const ChainEnd& start, std::span<const InnerVertex> vertices, const ChainEnd& end,
           std::span<const OffsetNormal> offsets = {});

  /// Movement of s_{i+1} (i from 0) if the end moves by `by`, whose part along the last ray does
  /// not count; of an end at infinity: the direction `toward` it.
  Vec3d moved(std::size_t i, const Vec3d& by) const;
  /// The most by which any vertex moves, over that by which the end does.
  double largest_move() const;
  /// True if the determinant of the derivatives of the constraints is negative. Of two chains
  /// between the same ends that merge at the border of a caustic, one is mirrored and the other is
  /// not.
  bool is_mirrored() const { return mirrored_; }
  /// |dω_a / dA_b|, the chain's generalised geometric term without the cosines at its ends: the
  /// solid angle at a (of a direction at infinity: area across it) over the area at b across the
  /// last ray (of a direction at infinity: solid angle).
  double spread() const;

 private:
  /// Two by two, by rows.
  using Block = std::array<double, 4>;
  struct Link {
    Vec3d x, y;                ///< orthonormal tangents of the surface
    Block before, own, after;  ///< derivatives of the constraint, by neighbours and itself
    Block by_end;              ///< derivative by the vertex
  };

  const Scene& scene_;
  std::vector<Link> links_;
  Vec3d end_x_{0.0}, end_y_{0.0};  ///< across the last ray
  Vec3d away_{0.0};                ///< from a to s₁
  double distance_ = 1.0;          ///< from a to s₁; 1 from infinity
  bool mirrored_ = false;
};

}  // namespace ajar
