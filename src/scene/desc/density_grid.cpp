#include "scene/desc/density_grid.h"

#include <algorithm>
#include <cmath>

namespace ajar::desc {

std::optional<std::string> complaint(const Density& density) {
  if (density.grid == nullptr) return "has no grid";
  const DensityGrid& grid = *density.grid;
  const int fewest = grid.points == DensityGrid::Points::Corners ? 2 : 1;
  const Vec3i& n = grid.resolution;
  const std::string size =
      std::to_string(n.x) + " × " + std::to_string(n.y) + " × " + std::to_string(n.z);
  if (std::min({n.x, n.y, n.z}) < fewest) {
    return "has a grid of " + size + ", which is fewer than " + std::to_string(fewest) +
           " along an axis";
  }
  // In doubles: products of three integers may be beyond what integers hold.
  const double count = double{1} * n.x * n.y * n.z;
  if (count != static_cast<double>(grid.values.size())) {
    return "has " + std::to_string(grid.values.size()) + " values of density, not " + size;
  }
  const auto is_fit = [](float value) { return value >= 0.F && std::isfinite(value); };
  if (!std::all_of(grid.values.begin(), grid.values.end(), is_fit)) {
    return "has a density that is negative or no number";
  }
  const double volume = density.to_world.determinant();
  if (!std::isfinite(volume) || volume == 0.0) return "has its density in a box without volume";
  return std::nullopt;
}

}  // namespace ajar::desc
