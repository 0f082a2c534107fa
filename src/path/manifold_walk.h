#pragma once
#include <optional>
#include <span>
#include <vector>

#include "path/path.h"
#include "path/specular_chain.h"

namespace ajar {

/// Start of a specular chain: a vertex of a path.
struct ChainStart {
  ChainEnd end;
  const InnerVertex* vertex = nullptr;  ///< null: an endpoint
  Vec3 ng{0.F};                         ///< geometric normal of an endpoint; 0 without a surface
  const Medium* medium = nullptr;       ///< around an endpoint
};
/// Vertex `x` < k of `path`, which must outlive it.
ChainStart chain_start(const Path& path, int x);
/// A point of a light.
ChainStart chain_start(const Light& light, const EndpointPoint& point);

/// Distance from `place` to the origin of rays toward it: the start of the chain, or the border of
/// the scene if that is nearer, as the error of rays grows with their length. Negative for a place
/// that lies yet farther from the scene.
double way_in(const Scene& scene, const ChainEnd& start, const Vec3d& place);

/// Moves the end b of a specular chain a, s₁ … sₙ, b to another place while a stays, by Newton's
/// method: steps in the tangent plane of s₁, from which the chain is traced again from a, by the
/// same specular events (lobe and side), and by facets of the same offset normals at rough
/// vertices, at whatever surfaces rays meet; a step that does not reduce the distance of the end is
/// halved. Walks are deterministic. Source: Jakob & Marschner 2012, "Manifold exploration", section
/// 4.2; that the end need not be on a surface is ours. Holds the scratch memory of one thread.
class ManifoldWalk {
 public:
  explicit ManifoldWalk(const Scene& scene) : scene_(scene), linear_(scene) {}

  /// Walks from `vertices` (in the order from the start), which lead to some place, to those that
  /// lead to `target`: false if none were found. Visibility of the last edge is not tested.
  /// `offsets`: new offset normals of rough vertices; none if all are specular.
  bool walk(const ChainStart& start, std::span<const InnerVertex> vertices, const Vec3& target,
            std::span<const OffsetNormal> offsets = {});
  /// Follows the ray from `start` through a place by specular events as the surfaces choose them,
  /// up to the first that scatters otherwise, `most` at most: false if there are none. Such chains
  /// are initial guesses of walks where no path is known.
  bool set_off(const ChainStart& start, const Vec3d& through, int most, SampleSource& source);
  /// The place of the first vertex that scatters otherwise; empty if it was not reached.
  const std::optional<Vec3>& landing() const { return landing_; }
  /// Result of the walk, or its initial guess, in the order from the start.
  std::span<const InnerVertex> vertices() const { return vertices_; }
  /// Bound of the distance of these from the chain that leads to `target` exactly, by the tolerance
  /// of walks.
  double uncertainty() const { return uncertainty_; }
  /// See `SpecularChain`: of where the walk came to.
  bool is_mirrored() const { return linear_.is_mirrored(); }

  const RayCounts& ray_counts() const { return rays_; }

 private:
  /// The next ray, from `start`.
  void leave(const ChainStart& start, const Vec3d& through);
  /// The next ray, from the vertex traced last.
  void leave(const Vec3& direction);
  /// To the next surface: null if there is none.
  InnerVertex* arrive();
  bool trace(const ChainStart& start, const Vec3d& through, std::span<const InnerVertex> events);
  bool measure(const ChainStart& start, std::span<const InnerVertex> vertices, const Vec3d& target);
  /// Direction in which vertex `i` of a chain continues light from the direction `back`.
  std::optional<Vec3d> onward(const InnerVertex& vertex, std::size_t i, const Vec3d& back) const;

  const Scene& scene_;
  SpecularChain linear_;
  std::vector<InnerVertex> vertices_;
  std::vector<InnerVertex> traced_;
  Ray ray_;  ///< from the last of these
  const Medium* medium_ = nullptr;
  std::optional<Vec3> landing_;
  std::span<const OffsetNormal> offsets_;  ///< offset normals of the current walk
  Vec3d miss_{0.0};  ///< from where a chain ends to the target, across the last ray
  /// Length of the edges from s₁ on, and of the part that rays cross before it if a is a point.
  double length_ = 0.0;
  double uncertainty_ = 0.0;
  RayCounts rays_;
};

}  // namespace ajar
