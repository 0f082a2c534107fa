#pragma once
#include <cstdint>

#include "mcmc/chain.h"
#include "path/path.h"

namespace ajar {

/// A chain in path space. I of all its states is 1: paths of each length have a measure of their
/// own, so only f/I reaches the film.
struct PathChain : Chain {
  Path path;
  std::uint64_t origin = 0;  ///< where it began, for messages
};

}  // namespace ajar
