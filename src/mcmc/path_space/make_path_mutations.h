#pragma once
#include <array>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "mcmc/path_space/path_bounds.h"
#include "mcmc/path_space/path_kernel.h"

namespace ajar {

/// An entry of the list of mutations.
struct PathMutationInfo {
  std::string_view name;
  std::string_view help;    ///< one line: what it does, for which paths
  std::string_view weight;  ///< by default, as text
  std::unique_ptr<PathMutation> (*make)(const Scene& scene, const PathBounds& bounds);
};
/// All of them, in the order of their numbers as moves.
std::span<const PathMutationInfo> path_mutations();
/// Mutations of paths as moves of kernels.
std::span<const Move> path_moves();

/// A kernel that mixes all of them, by number; weights may be 0. `scene` and `bounds` must outlive
/// it. `layer` and `weight`: see PathKernel.
PathKernel make_path_kernel(const Scene& scene, const PathBounds& bounds,
                            std::span<const double> weights, std::int32_t (*layer)(int depth),
                            PathWeight* weight = nullptr);

}  // namespace ajar
