#include "import/common/density.h"

#include <cmath>
#include <utility>

#include "core/printable_text.h"
#include "scene/desc/node.h"

namespace ajar {

namespace {
constexpr WarningKind kNoDensity{Effect::Surface,
                                 "densities are negative or no numbers: taken as 0"};
}

desc::DensityGridPointer make_grid(desc::DensityGrid grid, const SourceLocation& where,
                                   const std::string& name, Warnings& warnings) {
  std::size_t replaced = 0;
  const auto repair = [&](float& value) {
    if (value >= 0.F && std::isfinite(value)) return;
    value = 0.F;
    ++replaced;
  };
  for (float& value : grid.values) repair(value);
  for (std::vector<desc::Rgb>* colors : {&grid.absorption, &grid.scattering}) {
    for (desc::Rgb& color : *colors) {
      for (int lane = 0; lane < 3; ++lane) repair(color[lane]);
    }
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
