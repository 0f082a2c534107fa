#pragma once
#include <string>

#include "core/error.h"
#include "core/warnings.h"
#include "scene/desc/density_grid.h"

namespace ajar {

/// A grid of the medium `name`, which is made at `where`. Values that are negative or no numbers
/// count as 0, with a warning.
desc::DensityGridPointer make_grid(desc::DensityGrid grid, const SourceLocation& where,
                                   const std::string& name, Warnings& warnings);

/// `grid` in its place. Raises SceneError for grids and places that no medium can have.
desc::Density place_grid(desc::DensityGridPointer grid, const Mat4& to_world,
                         const SourceLocation& where);

/// Both.
desc::Density make_density(desc::DensityGrid grid, const Mat4& to_world,
                           const SourceLocation& where, const std::string& name,
                           Warnings& warnings);

}  // namespace ajar
