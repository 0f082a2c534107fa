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
#include "mcmc/primary/bootstrap_source.h"
#include "mcmc/primary/primary_runner.h"

namespace ajar {

/// Chains of primary numbers.
class PrimarySpace {
 public:
  using Member = MemberChain;

  /// Those of `ChainMoves`.
  explicit PrimarySpace(const Parameters& parameters) : moves_(parameters) {}

  static std::span<const Move> moves() { return primary_moves(); }

  static std::vector<Member> seed(const Scene& /*scene*/, const PathGroup& group,
                                  const ChainView& /*view*/, std::uint64_t bootstrap_seed,
                                  std::span<const double> weights, std::size_t chains) {
    return seed_chains(group, bootstrap_seed, weights, chains);
  }

  /// Chain `number` of those that start from a sample whose I is `weight`.
  static std::optional<Member> start(const Scene& /*scene*/, const PathGroup& group,
                                     const ChainView& /*view*/, const SampleOfChains& sample,
                                     std::uint64_t number) {
    return Member{PrimaryChain(group.shape, sample.chain_seed(number),
                               bootstrap_key(sample.seed, sample.index), sample.weight),
                  {},
                  1.0};
  }

  class Walker {
   public:
    Walker(const PrimarySpace& space, const Scene& scene, const PathGroup& group,
           const ChainView& view)
        : target_(make_path_target(scene, group, view)),
          runner_(space.moves_.settings, *space.moves_.mutation, group.shape, *target_),
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
  static void check_state(const Scene& scene, const PathGroup& group, const ChainView& view,
                          const Member& member) {
    ajar::check_state(member, *make_path_target(scene, group, view));
  }

 private:
  ChainMoves moves_;
};

}  // namespace ajar
