#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/vector.h"

namespace ajar::desc {

using Vec3i = Imath::V3i;

/// Density of a medium in the unit cube: factors of its coefficients, at the points of a lattice
/// and trilinear between them. Outside of the cube there is no medium.
struct DensityGrid {
  /// Where in the cube the points are: in the middle of as many cells as there are points, or at
  /// the corners of cells, the outer ones on the faces of the cube.
  enum class Points { Centers, Corners };
  /// Between the points in the middle of the outer cells and the faces of the cube, density goes on
  /// as if there were points of density 0 beyond, or of that of the nearest point.
  enum class Border { Zero, Clamp };

  Vec3i resolution{1, 1, 1};
  std::vector<float> values;  ///< x varies fastest, then y; finite, not negative
  Points points = Points::Centers;
  Border border = Border::Zero;
  /// Instead of `values`, of media whose colour varies: factors of the lanes of sigma_a and of
  /// sigma_s. If one of them is empty, it is 1 everywhere in the cube, up to the faces.
  std::vector<Vec3> absorption{}, scattering{};

  bool is_colored() const { return !absorption.empty() || !scattering.empty(); }
};
/// Shared, because grids are large.
using DensityGridPointer = std::shared_ptr<const DensityGrid>;

/// A grid in its place.
struct Density {
  DensityGridPointer grid;
  Mat4 to_world;  ///< transform of the unit cube
};

/// Why no medium can have `density`, as in "has 3 values of density, not 2 × 2 × 2"; nothing if one
/// can.
std::optional<std::string> complaint(const Density& density);

}  // namespace ajar::desc
