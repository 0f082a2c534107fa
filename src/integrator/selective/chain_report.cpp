#include "integrator/selective/chain_report.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "integrator/metropolis/chain_report.h"
#include "integrator/selective/chain_walker.h"

namespace ajar {

namespace {

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
  // Chains that stand by need not have anything to do, nor those for which nothing is hard.
  if (plan.standby || plan.unlit) return {};
  std::uint64_t lit = 0;
  std::uint64_t samples = plan.scouted;
  for (const ChainPopulation& population : populations) {
    samples += population.capped.count;
    lit += population.chains.size();
  }
  if (lit > 0 || populations.empty()) return {};
  return {no_seeds(samples)};
}

std::vector<std::string> notes_on(const ChainPlan& plan, std::optional<double> share,
                                  bool stand_by) {
  const std::string omc = words_for(plan.omc.techniques);
  if (plan.unlit) return {"no difficult light found: rendered by plain " + omc + " until some is"};
  if (plan.unprepared) {
    const bool of_time = plan.unprepared == Shortage::Time;
    return {std::string(of_time ? "too little time" : "too few samples") +
            " to look for difficult light: rendered by plain " + omc +
            "; for Markov chains, begin anew with more " + (of_time ? "time" : "samples")};
  }
  if (plan.standby) {
    return {"no difficult light found: rendered by plain " + omc +
            (stand_by ? "; Markov chains only take stray bright dots" : "")};
  }
  if (plan.divisions && plan.mutations == 0.0) {
    return {"no light is left to Markov chains: rendered by plain " + omc};
  }
  if (plan.divisions) {
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

MethodReport report_chains(const ChainPlan& plan, std::span<const ChainPopulation> populations,
                           double later_weight) {
  std::uint64_t samples = plan.scouted;
  for (const ChainPopulation& population : populations) samples += population.capped.count;
  ChainReporter reporter(samples);
  for (std::size_t g = 0; g < plan.groups.size(); ++g) {
    ChainReporter::OfGroup group(plan.groups[g], moves_of(plan.groups[g]));
    for (const ChainPopulation& population : populations) {
      if (population.group != g) continue;
      group.add_b(population.b(later_weight), population.b_standard_error(),
                  plan.settings.replicates);
      group.add_plain(population.plain_samples);
      group.add_retired(population.retired);
      for (const SelectiveChain& member : population.chains) group.add_chain(member.record);
    }
    reporter.add(std::move(group));
  }
  return reporter.report();
}

}  // namespace ajar
