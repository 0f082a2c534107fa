#include "import/common/density.h"

#include <cmath>
#include <utility>

#include "import/common/printable.h"

namespace ajar {

namespace {
constexpr WarningKind kNoDensity{Effect::Surface,
                                 "densities are negative or no numbers: taken as 0"};
}

desc::DensityGridPointer make_grid(desc::DensityGrid grid, const SourceLocation& where,
                                   const std::string& name, Warnings& warnings) {
  std::size_t replaced = 0;
  for (float& value : grid.values) {
    if (value >= 0.F && std::isfinite(value)) continue;
    value = 0.F;
    ++replaced;
  }
  if (replaced > 0) {
    warnings.add(kNoDensity, where,
                 std::to_string(replaced) +
                     " densities of this medium are negative or no numbers: taken as 0",
                 printable(name));
  }
  return std::make_shared<const desc::DensityGrid>(std::move(grid));
}

desc::Density place_grid(desc::DensityGridPointer grid, const Mat4& to_world,
                         const SourceLocation& where) {
  desc::Density density{std::move(grid), to_world};
  if (const std::optional<std::string> complaint = desc::complaint(density)) {
    throw SceneError(where, "the medium " + *complaint);
  }
  return density;
}

desc::Density make_density(desc::DensityGrid grid, const Mat4& to_world,
                           const SourceLocation& where, const std::string& name,
                           Warnings& warnings) {
  return place_grid(make_grid(std::move(grid), where, name, warnings), to_world, where);
}

}  // namespace ajar
