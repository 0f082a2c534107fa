#pragma once
#include <span>

#include "integrator/chain_plan.h"
#include "integrator/chain_population.h"
#include "integrator/integrator.h"

namespace ajar {

/// How the chains fared so far; `later_weight`: see `ChainPopulation::b`.
ChainReport report_chains(const ChainPlan& plan, std::span<const ChainPopulation> populations,
                          double later_weight);

}  // namespace ajar
