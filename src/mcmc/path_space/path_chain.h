#pragma once
#include <cstdint>

#include "mcmc/chain.h"
#include "path/path.h"

namespace ajar {

/// A chain in path space. I of all its states is 1: the light on a path has a measure of its own
/// for each length, of which no unit is better than another, and only what the path brings over
/// its I reaches the film.
struct PathChain : Chain {
  Path path;
  std::uint64_t origin = 0;  ///< where it began, for messages
};

}  // namespace ajar
