#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/archive.h"
#include "integrator/metropolis/chain_moves.h"
#include "integrator/metropolis/member_chain.h"
#include "integrator/metropolis/sample_of_chains.h"
#include "integrator/metropolis/visit_maps.h"
#include "mcmc/primary/bootstrap_source.h"
#include "mcmc/primary/primary_runner.h"

namespace ajar {

/// Chains of primary numbers, whose steps may follow the image plane (`VisitMaps`).
class PrimarySpace {
 public:
  using Member = MemberChain;

  explicit PrimarySpace(ChainMoves moves) : moves_(std::move(moves)) {}

  static std::span<const Move> moves() { return primary_moves(); }

  std::vector<Member> seed(const ChainProblem& problem, std::uint64_t bootstrap_seed,
                           std::span<const double> weights, std::size_t chains) const {
    return seed_chains(problem.group, bootstrap_seed, weights, chains, moves_.seeds);
  }
  /// Begins to count visits, if steps follow the image plane. `magnitude`: of the light on a pixel.
  void begin(const ChainView& view, int replicates, double magnitude) {
    if (!moves_.plane.active()) return;
    maps_ =
        std::make_unique<VisitMaps>(moves_.plane, view, replicates, magnitude, *moves_.mutation);
  }
  /// Null if steps do not follow the image plane.
  VisitMaps* maps() const { return maps_.get(); }

  /// Chain `number` of those that start from a sample whose I is `weight`.
  static std::optional<Member> start(const ChainProblem& problem, const SampleOfChains& sample,
                                     std::uint64_t number) {
    return Member{PrimaryChain(problem.group.shape, sample.chain_seed(number),
                               bootstrap_key(sample.seed, sample.index), sample.weight),
                  {},
                  1.0};
  }

  class Walker {
   public:
    Walker(const PrimarySpace& space, const ChainProblem& problem, int replicate)
        : target_(make_path_target(problem)),
          runner_(space.moves_.settings, *space.moves_.mutation, problem.group.shape, *target_,
                  space.maps_ ? space.maps_->moves(replicate) : nullptr),
          mis_large_steps_(space.moves_.mis_large_steps) {}
    void start(Member& member) { runner_.start(member.chain); }
    ChainStatistics go_on(Member& member, std::uint64_t steps, DepositSink& sink, double b) {
      return runner_.go_on(member.chain, steps, sink,
                           mis_large_steps_ ? std::optional(b) : std::nullopt);
    }
    const PathTarget* target() const { return target_.get(); }
    RayCounts ray_counts() const { return target_->ray_counts(); }

   private:
    std::unique_ptr<PathTarget> target_;
    PrimaryRunner runner_;
    bool mis_large_steps_;
  };

  static void save(OutputArchive& archive, const Scene& /*scene*/, const Member& member) {
    archive(member);
  }
  static void load(InputArchive& archive, const Scene& /*scene*/, Member& member) {
    archive(member);
  }
  static void check(const Member& member, const PathGroup& group, double most_steps) {
    check_member(member, group, most_steps);
  }
  static void check_state(const ChainProblem& problem, const Member& member) {
    ajar::check_state(member, *make_path_target(problem));
  }

 private:
  ChainMoves moves_;
  std::unique_ptr<VisitMaps> maps_;
};

}  // namespace ajar
