#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/archive_forward.h"
#include "core/random.h"
#include "integrator/metropolis/path_group.h"
#include "mcmc/bootstrap.h"
#include "mcmc/chain_statistics.h"
#include "mcmc/primary/primary_chain.h"
#include "mcmc/primary/step_kind.h"

namespace ajar {

/// Record of chains.
struct ChainRecord {
  ChainStatistics statistics;
  std::vector<MoveCount> by_technique;  ///< numbered as in the group's choice

  void add(const ChainRecord& other) {
    statistics += other.statistics;
    add_counts(by_technique, other.by_technique);
  }
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(statistics, by_technique);
  }
};

/// One of the chains that render a picture.
struct MemberChain {
  PrimaryChain chain;
  ChainRecord record;
  double weight = 1.0;  ///< factor of its deposits, relative to other chains (`seed_weight`)

  /// Number `number`, from 1, of further chains that start where this one is, with randomness of
  /// its own. A seed that is chosen m times starts m chains. One chain with m times the steps is biased:
  /// its start-up transient does not average out.
  MemberChain clone(std::uint64_t number) const {
    MemberChain other{chain, {}, weight};
    other.record.by_technique.resize(record.by_technique.size());
    other.chain.seed = hash_numbers(chain.seed, chain.step, number);
    return other;
  }
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(chain, record, weight);
  }
  std::uint64_t memory_bytes() const {
    return sizeof(MemberChain) - sizeof(PrimaryChain) + chain.memory_bytes();
  }
};

/// I of the bootstrap samples `first` to `last` (excluded) of a seed; what is no number, or below
/// zero, is counted when a chain meets it, and can be no seed: 0. `weights` has one for each.
void sample_bootstrap(PathTarget& target, std::uint64_t seed, std::uint64_t first,
                      std::uint64_t last, std::span<double> weights);

/// Selection of seeds (see `filter_weights`).
struct SeedRule {
  SeedFilter filter = SeedFilter::None;
  double spread = 3.0;  ///< standard deviations
};
/// `count` chains that start from samples of a bootstrap with this seed and these I, chosen in
/// proportion to I.
std::vector<MemberChain> seed_chains(const PathGroup& group, std::uint64_t bootstrap_seed,
                                     std::span<const double> weights, std::size_t count,
                                     const SeedRule& rule = {});

/// Counts what a chain of this origin has done in an item, and the rays it took. Its own record is
/// for who runs it: block by block, since sums depend on their order, and where passes are cut is
/// up to the clock.
void count_steps(std::uint64_t origin, const ChainStatistics& statistics, const RayCounts& rays,
                 Counters& counters);

/// Raise std::runtime_error for what chains that were read cannot have done, such as more than
/// `most_steps` steps, or more kinds of moves than there are.
void check_record(const ChainRecord& record, const PathGroup& group,
                  std::size_t moves = primary_moves().size());
void check_member(const MemberChain& member, const PathGroup& group, double most_steps);
/// Where a chain is, its target must say so, too: `ChainRunner` relies on it.
void check_state(const MemberChain& member, PathTarget& target);

}  // namespace ajar
