#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/parameters.h"
#include "mcmc/primary/primary_kernel.h"

namespace ajar {

/// Moves of chains in primary sample space: the parameters of the published methods (Kelemen et al.
/// 2002; Hachisuka et al. 2014), and their settings.
struct ChainMoves {
  /// Defaults of the parameters of these names.
  struct Defaults {
    std::string mutation = "kelemen";
    std::string large_step = "0.3";
  };
  static std::vector<ParameterSpec> parameters(const Defaults& defaults);

  /// Raises UsageError.
  explicit ChainMoves(const Parameters& parameters)
      : ChainMoves(parameters, parameters.get_text("mutation")) {}
  /// For methods that have a mutation of their own, of which `mutation_name` is a part.
  ChainMoves(const Parameters& parameters, std::string_view mutation_name);

  PrimarySettings settings;
  std::unique_ptr<Mutation> mutation;
  bool mis_large_steps;
};

}  // namespace ajar
