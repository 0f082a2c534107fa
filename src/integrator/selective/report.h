#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "integrator/selective/chain_population.h"
#include "integrator/selective/division_pilot.h"
#include "integrator/selective/preparation.h"
#include "integrator/selective/sample_allocation.h"

namespace ajar {

/// Everything that a report tells of; a null pointer where there is no such thing.
struct SelectiveStatus {
  const SelectivePreparation& prepared;
  const DivisionResult* division;
  std::span<const ChainPopulation> populations;
  const SampleAllocation& allocation;
};

/// Notes for those who light scenes: which light chains make.
std::vector<std::string> notes_on(const SelectiveStatus& status);

/// Statistics of chains, division and regions.
MethodReport report_on(const SelectiveStatus& status);

/// Chain fraction of a path as bright as its pixel, relative to the lowest T.
Plane chain_importance(const SelectivePreparation& prepared);

}  // namespace ajar
