#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "integrator/integrator.h"
#include "integrator/selective/chain_plan.h"
#include "integrator/selective/chain_population.h"

namespace ajar {

/// After the preparation: what the user should know of the chains.
std::vector<Warning> concerns_about(const ChainPlan& plan,
                                    std::span<const ChainPopulation> populations);
/// And what they may like to know, in the words of those who light scenes: what is made by chains.
/// `share`: of the picture, if it is known; `stand_by`: whether chains stand by where they would
/// not pay.
std::vector<std::string> notes_on(const ChainPlan& plan, std::optional<double> share,
                                  bool stand_by);

/// How the chains fared so far; `later_weight`: see `ChainPopulation::b`.
MethodReport report_chains(const ChainPlan& plan, std::span<const ChainPopulation> populations,
                           double later_weight);

}  // namespace ajar
