#include "mcmc/path_space/perturbation_law.h"

#include <algorithm>

#include "mcmc/path_space/heuristics.h"

namespace ajar {

PerturbationLaw raster_law(const Vec2i& pixels) {
  const double area = static_cast<double>(pixels.x) * static_cast<double>(pixels.y);
  const double smallest = PathSpaceHeuristics::kSmallestRasterMove;
  const double largest =
      std::sqrt(PathSpaceHeuristics::kLargestRasterDisc * area / std::numbers::pi);
  // Pictures of a few pixels.
  return {smallest, std::max(largest, 2.0 * smallest)};
}

}  // namespace ajar
