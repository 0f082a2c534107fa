#include "scene/desc/density_grid.h"

#include <algorithm>
#include <cmath>

namespace ajar::desc {

namespace {

bool is_fit(float value) { return value >= 0.F && std::isfinite(value); }
bool is_fit(const Vec3& value) { return is_fit(value.x) && is_fit(value.y) && is_fit(value.z); }

}  // namespace

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
  // In doubles: products of three integers may overflow integers.
  const double count = double{1} * n.x * n.y * n.z;
  const auto check = [&](const auto& values, const std::string& many,
                         const std::string& one) -> std::optional<std::string> {
    if (count != static_cast<double>(values.size())) {
      return "has " + std::to_string(values.size()) + " " + many + ", not " + size;
    }
    for (const auto& value : values) {
      if (!is_fit(value)) return "has " + one + " that is negative or no number";
    }
    return std::nullopt;
  };
  if (grid.is_colored() && !grid.values.empty()) return "has both densities and colours";
  std::optional<std::string> wrong;
  if (!grid.is_colored()) wrong = check(grid.values, "values of density", "a density");
  if (!grid.absorption.empty()) {
    wrong = check(grid.absorption, "colours of absorption", "an absorption");
  }
  if (!wrong && !grid.scattering.empty()) {
    wrong = check(grid.scattering, "colours of scattering", "a scattering");
  }
  if (wrong) return wrong;
  const double volume = density.to_world.determinant();
  if (!std::isfinite(volume) || volume == 0.0) return "has its density in a box without volume";
  return std::nullopt;
}

}  // namespace ajar::desc
