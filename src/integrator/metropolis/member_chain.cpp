#include "integrator/metropolis/member_chain.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "core/random_use.h"
#include "mcmc/primary/bootstrap_source.h"
#include "mcmc/primary/chain_source.h"
#include "mcmc/primary/step_sizes.h"

namespace ajar {

namespace {

void require(bool holds, const char* otherwise) {
  if (!holds) throw std::runtime_error(otherwise);
}

bool is_sum(double value) { return value >= 0.0 && std::isfinite(value); }

template <typename Count>
void check_counts(const std::vector<Count>& counts) {
  for (const MoveCount& count : counts) {
    require(is_sum(count.acceptances), "what chains have accepted cannot be");
  }
}

}  // namespace

void sample_bootstrap(PathTarget& target, std::uint64_t seed, std::uint64_t first,
                      std::uint64_t last, std::span<double> weights) {
  SplatBuffer splats;
  for (std::uint64_t i = first; i < last; ++i) {
    BootstrapSource source(seed, i);
    splats.clear();
    const double scalar = target.evaluate(source, Change{}, splats);
    target.rejected();
    weights[i - first] = scalar > 0.0 && std::isfinite(scalar) ? scalar : 0.0;
  }
}

std::vector<MemberChain> seed_chains(const PathGroup& group, std::uint64_t bootstrap_seed,
                                     std::span<const double> weights, std::size_t count,
                                     const SeedRule& rule) {
  const float u = to_unit_float(
      static_cast<std::uint32_t>(hash_numbers(bootstrap_seed, RandomUse::Seeds) >> 32U));
  ChainRecord empty;
  empty.by_technique.resize(group.choice.size());
  const std::vector<double> filtered = filter_weights(weights, rule.filter, rule.spread);
  std::vector<MemberChain> chains;
  for (const std::size_t index : choose_seeds(filtered, count, u)) {
    const std::uint64_t chain_seed = hash_numbers(bootstrap_seed, RandomUse::Chain, chains.size());
    chains.push_back({PrimaryChain(group.shape, chain_seed, bootstrap_key(bootstrap_seed, index),
                                   weights[index]),
                      empty, seed_weight(weights, filtered, rule.filter, index)});
  }
  return chains;
}

void count_steps(std::uint64_t origin, const ChainStatistics& statistics, const RayCounts& rays,
                 Counters& counters) {
  counters.mutations += statistics.steps;
  counters.add_rays(rays);
  counters.discarded_nan += statistics.discarded_nan;
  counters.discarded_infinite += statistics.discarded_infinite;
  counters.discarded_negative += statistics.discarded_negative;
  if (statistics.first_discarded && counters.first_discarded.empty()) {
    const auto& place = *statistics.first_discarded;
    counters.first_discarded = "proposal of the chain with seed " + std::to_string(place.seed) +
                               ", origin " + std::to_string(origin) + ", after " +
                               std::to_string(place.step) + " steps";
  }
}

void check_record(const ChainRecord& record, const PathGroup& group, std::size_t moves) {
  const std::size_t counted = record.by_technique.size();
  require(counted == 0 || counted == group.choice.size(),
          "corrupt checkpoint: a chain does not fit its population");
  const ChainStatistics& statistics = record.statistics;
  require(statistics.moves.size() <= moves, "corrupt checkpoint: unknown moves of chains");
  check_counts(statistics.moves);
  check_counts(record.by_technique);
}

void check_member(const MemberChain& member, const PathGroup& group, double most_steps) {
  check_record(member.record, group);
  const PrimaryChain& chain = member.chain;
  require(static_cast<double>(chain.step) <= most_steps,
          "corrupt checkpoint: too many steps of a chain");
  require(chain.numbers.can_be_after(chain.step), "corrupt checkpoint: invalid numbers of a chain");
  require(chain.step_scale > 0.F && chain.step_scale <= StepSizes::kLargest,
          "steps of a chain cannot be that long");
  require(member.weight != 0.0 && std::isfinite(member.weight), "a chain weighs nothing");
}

void check_state(const MemberChain& member, PathTarget& target) {
  ReplaySource source(member.chain.numbers);
  SplatBuffer splats;
  const double scalar = target.evaluate(source, Change{}, splats);
  require(scalar == member.chain.scalar && std::isnormal(scalar) && scalar > 0.0,
          "a chain is where it cannot be");
}

}  // namespace ajar
