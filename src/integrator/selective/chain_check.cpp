#include "integrator/selective/chain_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/milestones.h"
#include "core/parallel_for.h"
#include "mcmc/primary/chain_source.h"

namespace ajar {

namespace {

void require(bool holds, const char* otherwise) {
  if (!holds) throw std::runtime_error(otherwise);
}

bool is_sum(double value) { return value >= 0.0 && std::isfinite(value); }

void check_moments(const Moments& moments) {
  require(is_sum(moments.sum) && is_sum(moments.sum_of_squares), "samples of chains cannot be");
}

void check_counts(std::span<const MoveCount> counts) {
  for (const MoveCount& count : counts) {
    require(is_sum(count.acceptances), "what chains have accepted cannot be");
  }
}

void check_statistics(const ChainStatistics& statistics) {
  require(statistics.moves.size() <= step_names().size(), "chains cannot have made such steps");
  check_counts(statistics.moves);
  check_moments(statistics.large_steps);
}

void check_member(const MemberChain& member, std::size_t techniques, double most_steps) {
  const std::size_t counted = member.record.by_technique.size();
  require(counted == 0 || counted == techniques, "a chain does not fit its population");
  check_statistics(member.record.statistics);
  check_counts(member.record.by_technique);
  const PrimaryChain& chain = member.chain;
  require(static_cast<double>(chain.step) <= most_steps, "a chain has made too many steps");
  require(chain.numbers.can_be_after(chain.step), "a chain has numbers that cannot be");
  require(chain.step_scale > 0.F && chain.step_scale <= StepSizes::kLargest,
          "steps of a chain cannot be that long");
  require(member.weight != 0.0 && std::isfinite(member.weight), "a chain weighs nothing");
}

/// Where a chain is, its target must say so, too: `ChainRunner` relies on it.
void check_states(const ChainPopulation& population, const ChainPlan& plan) {
  const PathGroup& group = plan.groups[population.group];
  parallel_for(population.chains.size(), [&](std::size_t i) {
    const PrimaryChain& chain = population.chains[i].chain;
    const auto target = plan.make_target(group, population.replicate);
    ReplaySource source(chain.numbers);
    SplatBuffer splats;
    const double scalar = target->evaluate(source, Change{}, splats);
    require(scalar == chain.scalar && std::isnormal(scalar) && scalar > 0.0,
            "a chain is where it cannot be");
  });
}

}  // namespace

void check_population(const ChainPopulation& population, const ChainPlan& plan,
                      std::uint64_t samples) {
  const auto replicates = static_cast<std::uint64_t>(plan.settings.replicates);
  // A pass that was cut short may have come as far as this; each sample has a step at least.
  const auto passes = static_cast<double>(milestone_after(samples, replicates));
  const double most_steps = passes * (1.0 + std::max(plan.mutations, ChainPlan::kMostMutations) *
                                                static_cast<double>(plan.pixels()));
  const std::size_t techniques = plan.groups[population.group].choice.size();
  for (const MemberChain& member : population.chains) check_member(member, techniques, most_steps);
  require(population.retired.by_technique.size() <= techniques,
          "a chain does not fit its population");
  check_statistics(population.retired.statistics);
  check_counts(population.retired.by_technique);
  check_statistics(population.plain_statistics);
  constexpr double kMostSamples = 0x1p63;
  require(population.samples_behind >= 0.0 && population.samples_behind < kMostSamples,
          "chains stand for samples that cannot be");
  if (const auto& joined = population.joined) {
    require(is_sum(joined->b) && is_sum(joined->variance) && is_sum(joined->of_recruits) &&
                is_sum(joined->of_chains) && (joined->b > 0.0 || population.chains.empty()),
            "the brightness of chains cannot be");
  }
  check_states(population, plan);
}

}  // namespace ajar
