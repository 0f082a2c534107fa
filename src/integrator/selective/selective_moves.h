#pragma once
#include <vector>

#include "integrator/metropolis/chain_moves.h"
#include "integrator/metropolis/path_group.h"
#include "mcmc/primary/plane_moves.h"

namespace ajar {

/// Moves that the published methods do not have: steps of other lengths, of one half of a path or
/// of its place on the picture, steps that follow the picture (He et al. 2019, 2020), and several
/// tries.
struct SelectiveMoves : ChainMoves {
  static std::vector<ParameterSpec> parameters();

  /// Raises UsageError.
  SelectiveMoves(const Parameters& parameters, ChainKind kind);

  PlaneRule plane;
  bool raster_steps_are_open = false;  ///< the user leaves them to us
};

}  // namespace ajar
