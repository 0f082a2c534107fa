#include "integrator/selective/chain_report.h"

#include <cmath>

namespace ajar {

namespace {

constexpr WarningKind kNoSeeds{Effect::Light, "methods have found no light to start chains from"};

std::string words_for(const std::string& techniques) {
  if (techniques == "pt") return "path tracing";
  if (techniques == "lt") return "light tracing";
  if (techniques == "ibpt") return "path and light tracing";
  if (techniques == "bdpt") return "bidirectional path tracing";
  return "Monte Carlo (" + techniques + ")";
}

std::string percent(double share) {
  const auto rounded = static_cast<int>(std::lround(100.0 * share));
  return rounded < 1 ? "less than 1 %" : "about " + std::to_string(rounded) + " %";
}

}  // namespace

std::vector<Warning> concerns_about(const ChainPlan& plan,
                                    std::span<const ChainPopulation> populations) {
  // Chains that stand by need not have anything to do.
  if (plan.standby) return {};
  std::uint64_t lit = 0;
  std::uint64_t samples = plan.scouted;
  for (const ChainPopulation& population : populations) {
    samples += population.capped.count;
    lit += population.chains.size();
  }
  if (lit > 0 || populations.empty()) return {};
  return {{kNoSeeds,
           {},
           "no light was found for Markov chains in " + std::to_string(samples) +
               " tries: light that comes by way of several surfaces may be missing; see whether "
               "the lamps reach what the camera sees, allow longer paths (--depth), or let it try "
               "more often (--set bootstrap=10000000)"}};
}

std::vector<std::string> notes_on(const ChainPlan& plan, std::optional<double> share,
                                  bool stand_by) {
  const std::string omc = words_for(plan.omc.techniques);
  if (plan.unprepared) {
    return {"too little time to look for difficult light: plain " + omc + " makes this picture"};
  }
  if (plan.standby) {
    return {"no difficult light found: plain " + omc + " makes this picture" +
            (stand_by ? "; Markov chains only take stray bright dots" : "")};
  }
  if (plan.splits && plan.mutations == 0.0) {
    return {"no light is left to Markov chains: plain " + omc + " makes this picture"};
  }
  if (plan.splits) {
    const std::string difficult = "difficult light (caustics, light through gaps)";
    if (!share) return {"Markov chains make " + difficult + ", " + omc + " the rest"};
    return {difficult + " in " + percent(*share) + " of this picture: Markov chains make it, " +
            omc + " the rest"};
  }
  if (plan.direct == ChainPlan::Direct::Chain) return {"Markov chains make all light"};
  return {
      "Markov chains make all light but what comes straight from lamps, or by way of one "
      "surface"};
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
    MoveCount all;
    for (const MoveCount& move : own.moves) all += move;
    depth.acceptance = all.acceptance();
    for (std::size_t s = 0; s < record.by_technique.size(); ++s) {
      const MoveCount& count = record.by_technique[s];
      if (count.proposals == 0) continue;
      report.techniques.push_back({choice[s], count.proposals, count.acceptance()});
    }
    report.depths.push_back(depth);
    whole += own;
  }
  MoveCount small;
  for (std::size_t i = 0; i < whole.moves.size(); ++i) {
    const MoveCount& move = whole.moves[i];
    if (move.proposals == 0) continue;
    report.moves.push_back({std::string(step_names()[i]), move.proposals, move.acceptance()});
    if (i == move_of(StepKind::Large)) {
      report.large_acceptance = move.acceptance();
    } else {
      small += move;
    }
  }
  report.small_acceptance = small.acceptance();
  report.longest_rejection_streak = whole.longest_streak;
  return report;
}

}  // namespace ajar
