#include "integrator/chain_report.h"

#include <cmath>

namespace ajar {

namespace {

constexpr WarningKind kNoSeeds{Effect::Light, "methods have found no light to start chains from"};

}  // namespace

std::vector<Warning> concerns_about(const ChainPlan& plan,
                                    std::span<const ChainPopulation> populations) {
  std::uint64_t lit = 0;
  std::uint64_t samples = plan.scouted;
  for (const ChainPopulation& population : populations) {
    samples += population.capped.count;
    lit += population.chains.size();
  }
  if (lit > 0 || populations.empty()) return {};
  return {{kNoSeeds,
           {},
           "none of " + std::to_string(samples) +
               " bootstrap paths carries light, so there is nothing to start Markov chains from: "
               "indirect light is sampled without them and may stay black; try a larger bootstrap "
               "(--set bootstrap=10000000), a larger --depth, or see whether the scene has lights "
               "that reach what the camera sees"}};
}

std::vector<std::string> notes_on(const ChainPlan& plan, bool stand_by) {
  if (plan.unprepared) {
    return {"no time to prepare Markov chains: ordinary Monte Carlo alone renders this picture"};
  }
  if (!plan.standby) return {};
  return {
      "nothing in this picture is so hard that Markov chains would pay: ordinary Monte Carlo (" +
      plan.omc.techniques + ") renders it" +
      (stand_by ? "; chains only stand by for fireflies" : " alone")};
}

ChainReport report_chains(const ChainPlan& plan, std::span<const ChainPopulation> populations,
                          double later_weight) {
  ChainReport report;
  report.bootstrap_samples = plan.scouted;
  ChainStatistics whole;
  for (std::size_t g = 0; g < plan.groups.size(); ++g) {
    ChainReport::Depth depth{plan.groups[g].depth, 0, 0, 0.0, 0.0, 0.0};
    ChainRecord record;
    double variance = 0.0;
    const TechniqueChoice& choice = plan.groups[g].choice;
    for (const ChainPopulation& population : populations) {
      if (population.group != g) continue;
      report.bootstrap_samples += population.capped.count;
      depth.b += population.b(later_weight) / plan.settings.replicates;
      const double error = population.b_standard_error();
      variance += error * error;
      depth.chains += population.chains.size();
      depth.mutations += population.plain_samples;
      record.add(population.retired);
      for (const MemberChain& member : population.chains) record.add(member.record);
    }
    depth.b_standard_error = std::sqrt(variance) / plan.settings.replicates;
    const ChainStatistics& own = record.statistics;
    depth.mutations += own.steps;
    double accepted = 0.0;
    for (const ChainStatistics::Kind& kind : own.kinds) accepted += kind.acceptances;
    if (own.steps > 0) depth.acceptance = accepted / static_cast<double>(own.steps);
    for (std::size_t s = 0; s < record.by_technique.size(); ++s) {
      const ChainStatistics::Kind& kind = record.by_technique[s];
      if (kind.proposals == 0) continue;
      report.techniques.push_back(
          {choice[s], kind.proposals, kind.acceptances / static_cast<double>(kind.proposals)});
    }
    report.depths.push_back(depth);
    whole += own;
  }
  const auto mean = [](std::initializer_list<ChainStatistics::Kind> kinds) {
    ChainStatistics::Kind sum;
    for (const ChainStatistics::Kind& kind : kinds) {
      sum.proposals += kind.proposals;
      sum.acceptances += kind.acceptances;
    }
    return sum.proposals > 0 ? sum.acceptances / static_cast<double>(sum.proposals) : 0.0;
  };
  report.large_acceptance = mean({whole.of(StepKind::Large)});
  report.small_acceptance = mean({whole.of(StepKind::SmallBoth), whole.of(StepKind::SmallCamera),
                                  whole.of(StepKind::SmallLight), whole.of(StepKind::SmallRaster)});
  report.longest_rejection_streak = whole.longest_streak;
  return report;
}

}  // namespace ajar
