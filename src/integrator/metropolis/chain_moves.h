#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/parameters.h"
#include "integrator/metropolis/member_chain.h"
#include "mcmc/primary/plane_moves.h"
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
  std::shared_ptr<const Mutation> mutation;
  bool mis_large_steps;
  PlaneRule plane{};  ///< rule of steps that follow the image plane
  SeedRule seeds{};
};

}  // namespace ajar
