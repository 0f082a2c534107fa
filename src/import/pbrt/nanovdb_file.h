#pragma once
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/error.h"
#include "scene/desc/density_grid.h"

namespace ajar::pbrt {

/// A grid, at the resolution of its voxels, and where the file places it.
struct VoxelGrid {
  desc::DensityGrid grid;
  Mat4 to_world;  ///< transform of the unit cube
};

/// The grid called `grid_name` in the bytes of a NanoVDB file, where its voxels are active; nothing
/// if there is none of this name. Numbers may be floats, doubles, or floats in 4, 8, 16 or any
/// number of bits, blocks uncompressed or compressed by zlib. Raises SceneError, at `where`, for
/// other ones, for damaged files, and for grids of more than `most_voxels` or than memory can hold.
/// Density between voxels and around them is pbrt-v4's, by trilinear interpolation.
std::optional<VoxelGrid> read_nanovdb(std::string_view bytes, std::string_view grid_name,
                                      const SourceLocation& where,
                                      std::uint64_t most_voxels = std::uint64_t{1} << 30);

/// True if the file has a grid of this name. Raises SceneError.
bool has_nanovdb_grid(std::string_view bytes, std::string_view grid_name,
                      const SourceLocation& where);

}  // namespace ajar::pbrt
