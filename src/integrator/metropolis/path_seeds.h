#pragma once
#include <optional>

#include "integrator/metropolis/path_group.h"
#include "mcmc/path_space/path_weight.h"
#include "path/path.h"

namespace ajar {

/// Sample `index` of a bootstrap with this seed whose states are all connections of two subpaths
/// (`WholePathTarget`), once more: one of its paths, chosen in proportion to what it brings. So
/// samples that are chosen in proportion to I, which is the sum, give paths in proportion to their
/// light, MIS weights included, by all techniques. `u` in [0, 1) is uniform. Empty if none of them
/// can be a state of a chain (edges that rounding interrupts when traced again). If chains do not
/// make all light, `part` and `weight` tell what they do of what techniques bring and on paths.
std::optional<Path> choose_path(const Scene& scene, const PathGroup& group, const ChainView& view,
                                std::uint64_t seed, std::uint64_t index, double u,
                                const PathPart* part = nullptr, PathWeight* weight = nullptr);

}  // namespace ajar
