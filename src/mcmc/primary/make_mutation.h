#pragma once
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "mcmc/primary/mutation.h"

namespace ajar {

/// Names of all mutations, sorted.
std::span<const std::string> mutation_names();
/// `sigma` is the standard deviation of `gaussian`, in units of the primary interval. Raises
/// UsageError with the nearest name.
std::unique_ptr<Mutation> make_mutation(std::string_view name, double sigma);

}  // namespace ajar
