#pragma once
#include <memory>
#include <string>
#include <vector>

#include "core/parameters.h"
#include "integrator/metropolis/path_group.h"
#include "mcmc/primary/plane_moves.h"
#include "mcmc/primary/primary_kernel.h"

namespace ajar {

/// How chains in primary sample space move, as users say it: the parameters of the published
/// methods (Kelemen et al. 2002; Hachisuka et al. 2014; He et al. 2019, 2020), and what comes of
/// them.
struct ChainMoves {
  /// Of the parameters of these names: as published, unless somebody knows better.
  struct Defaults {
    std::string mutation = "kelemen";
    std::string large_step = "0.3";
    std::string fine_steps = "0";
    /// "auto": `MetropolisHeuristics::kRasterSteps` for states of one path, where nothing forbids.
    std::string raster_steps = "0";
  };
  static std::vector<ParameterSpec> parameters(const Defaults& defaults);

  /// Raises UsageError.
  ChainMoves(const Parameters& parameters, ChainKind kind);

  PrimarySettings settings;
  std::unique_ptr<Mutation> mutation;
  PlaneRule plane;
  bool mis_large_steps;
  bool raster_steps_are_open = false;  ///< the user leaves them to us
};

}  // namespace ajar
