#pragma once
#include <vector>

#include "core/parameters.h"
#include "integrator/metropolis/chain_moves.h"

/// Extensions of `mmlt` by others than its authors, as published and exact:
///
///   step=adaptive, mutation=slemmlt|fusion   steps that follow the image plane (He et al. 2019,
///                                            2020; docs/methods/mutations.md)
///   multi-try                                several proposals per mutation (Liu et al. 2000)
///   seeds                                    bootstrap samples without outliers (He 2018)
///   camera-steps, light-steps                steps of one half of a path, whose other half is not
///                                            traced again
namespace ajar {

/// Appends their parameters, all off by default, to those of `ChainMoves`.
void add_mmlt_extensions(std::vector<ParameterSpec>& specs);

/// The moves of `mmlt` with these parameters. Raises UsageError.
ChainMoves mmlt_moves(const Parameters& parameters);

}  // namespace ajar
