#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>

#include "core/error.h"
#include "core/warnings.h"
#include "scene/desc/density_grid.h"

namespace ajar::pbrt {

/// The procedural cloud of pbrt-v4.
struct Cloud {
  float density = 1.F, wispiness = 1.F, frequency = 5.F;
  Vec3 low{0.F}, high{1.F};  ///< its box, in the space of the medium

  /// At a point of that space, 0 to 1. Source: Pharr et al. 2023, section 11.4.5.
  float at(const Vec3& p) const;
};

/// Along the axes, of the lattice that has two points for each period of the finest noise, or fewer
/// so that there are at most `most_points` in all, which is at least 8.
desc::Vec3i lattice_of(const Cloud& cloud, std::uint64_t most_points);

/// True if that lattice is too coarse for the finest noise.
bool is_finer_than_grids(const Cloud& cloud, std::uint64_t most_points);

/// The density at the points of that lattice. Its unit cube is the box.
desc::DensityGrid tabulate(const Cloud& cloud, std::uint64_t most_points);

/// The grids of all clouds of a file. Equal clouds share one. A new one has at most half of the
/// remaining points, so that no number of clouds exceeds the limit, but for the 8 that the smallest
/// has.
class CloudGrids {
 public:
  /// Limit per file: the first cloud alone has up to 256³.
  static constexpr std::uint64_t kMostPoints = std::uint64_t{1} << 25U;

  explicit CloudGrids(std::uint64_t most_points = kMostPoints) : points_left_(most_points) {}

  /// Grid of `cloud`, which is made at `where` as the medium `name`. Warns of grids that are
  /// coarser than the noise. Raises SceneError if there is no memory for it.
  desc::DensityGridPointer get(const Cloud& cloud, const SourceLocation& where,
                               const std::string& name, Warnings& warnings);

 private:
  struct Entry {
    desc::DensityGridPointer grid;
    bool is_coarse;
  };
  using Key = std::array<std::uint32_t, 9>;  ///< bits of the parameters

  static Key key_of(const Cloud& cloud);

  std::uint64_t points_left_;
  std::map<Key, Entry> made_;
};

}  // namespace ajar::pbrt
