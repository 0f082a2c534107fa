#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "mcmc/kernel.h"
#include "mcmc/path_space/path_bounds.h"
#include "mcmc/path_space/path_chain.h"
#include "mcmc/path_space/path_mutation.h"
#include "mcmc/path_space/path_weight.h"

namespace ajar {

/// A mutation, and how often it is tried beside others that are suitable.
struct MixedMutation {
  std::unique_ptr<PathMutation> mutation;
  double weight;
};

/// Steps in path space (Veach 1997, chapter 11): the state is a path, its density in proportion to
/// the luminance of its contribution to an area of the film. A step chooses among the suitable
/// mutations, by weights that are normalised over them; each keeps the density by itself, so only
/// the selection probability enters both directions.
class PathKernel final : public Kernel {
 public:
  /// `scene` must outlive it; at least one mutation. `layer`: of the film, by the number of edges.
  /// `weight`, which must outlive it as well, multiplies the light: null for 1.
  PathKernel(const Scene& scene, const PathBounds& bounds, std::vector<MixedMutation> mutations,
             std::int32_t (*layer)(int depth), PathWeight* weight = nullptr);

  /// Goes on with a chain, which must stay where it is meanwhile. Raises std::logic_error if there
  /// is no light on its path.
  void start(PathChain& chain);

  std::span<const Move> moves() const override { return moves_; }
  std::span<const Splat> current() const override { return splats_; }
  Proposal propose(std::uint64_t key) override;
  void accept(std::size_t candidate) override;
  void reject() override {}

  RayCounts ray_counts() const;

 private:
  /// Data of a path that is a state.
  struct State {
    double log_light = 0.0;  ///< ln f*, times `PathWeight`
    double weight = 0.0;     ///< total weight of all suitable mutations
  };
  double suitable_weight(const Path& path) const;
  /// The mutation that a step from the current path tries; null if none is for it.
  PathMutation* choose(std::uint64_t key);
  void consider(PathMutation& mutation, std::uint64_t key);

  const Scene& scene_;
  PathBounds bounds_;
  std::vector<MixedMutation> mutations_;
  std::vector<Move> moves_;
  std::int32_t (*layer_)(int depth);
  PathWeight* weight_;
  PathChain* chain_ = nullptr;
  State current_;
  State proposed_;
  SplatBuffer splats_;  ///< splats of the current path
  Path path_;           ///< the proposal
  /// The one that was chosen last, in `moves_`.
  std::optional<std::size_t> move_;
  bool without_density_ = false;
  Candidate candidate_;
};

/// ln f* of a path, times `weight` if that is not null, and its splats at I = 1: nothing, and −∞,
/// if it has no light, or if its place or the depth that counts is not within bounds; NaN if its
/// light is NaN, or negative.
double light_on(const Scene& scene, const Path& path, const PathBounds& bounds, std::int32_t layer,
                SplatBuffer& splats, PathWeight* weight = nullptr);

}  // namespace ajar
