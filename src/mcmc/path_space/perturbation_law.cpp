#include "mcmc/path_space/perturbation_law.h"

#include <algorithm>

#include "mcmc/path_space/heuristics.h"
#include "path/raster_area.h"

namespace ajar {

PerturbationLaw raster_law(const Vec2i& pixels) {
  const double smallest = PathSpaceHeuristics::kSmallestRasterMove;
  const double largest =
      std::sqrt(PathSpaceHeuristics::kLargestRasterDisc * image_area(pixels) / std::numbers::pi);
  // Pictures of a few pixels.
  return {smallest, std::max(largest, 2.0 * smallest)};
}

}  // namespace ajar
