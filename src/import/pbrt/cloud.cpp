#include "import/pbrt/cloud.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/parallel_for.h"
#include "core/perlin_noise.h"
#include "core/printable_text.h"
#include "import/common/density.h"
#include "os/available_memory.h"

namespace ajar::pbrt {
namespace {

constexpr float kLacunarity = 1.99F;
constexpr int kOctaves = 5;
constexpr int kMostCells = 255;  ///< along an axis

constexpr WarningKind kCloud{Effect::Slight,
                             "clouds are finer than the grids that are made of them"};

/// Gradient of the noise, by differences.
Vec3 slope_of_noise(const Vec3& p) {
  constexpr float kStep = 0.01F;
  const float here = noise(p);
  return Vec3(noise(p + Vec3(kStep, 0, 0)) - here, noise(p + Vec3(0, kStep, 0)) - here,
              noise(p + Vec3(0, 0, kStep)) - here) /
         kStep;
}

/// Number of cells along the axes for the finest noise.
Vec3 wanted_cells(const Cloud& cloud) {
  const float finest = cloud.frequency * std::pow(kLacunarity, static_cast<float>(kOctaves - 1));
  Vec3 cells = (cloud.high - cloud.low) * (2.F * finest);
  for (int i = 0; i < 3; ++i) cells[i] = std::ceil(std::abs(cells[i]));
  return cells;
}

/// Points of the lattice that has them, but at most `most_cells` cells, along each axis.
desc::Vec3i lattice_within(const Vec3& wanted, int most_cells) {
  desc::Vec3i points;
  for (int i = 0; i < 3; ++i) {
    // NaN becomes one cell.
    points[i] = 1 + static_cast<int>(std::clamp(wanted[i] >= 1.F ? wanted[i] : 1.F, 1.F,
                                                static_cast<float>(most_cells)));
  }
  return points;
}

std::uint64_t product(const desc::Vec3i& n) {
  return static_cast<std::uint64_t>(n.x) * static_cast<std::uint64_t>(n.y) *
         static_cast<std::uint64_t>(n.z);
}

}  // namespace

float Cloud::at(const Vec3& p) const {
  Vec3 place = p * frequency;
  if (wispiness > 0.F) {
    float strength = 0.05F * wispiness;
    float scale = 10.F;
    for (int i = 0; i < 2; ++i) {
      place += slope_of_noise(place * scale) * strength;
      strength *= 0.5F;
      scale *= kLacunarity;
    }
  }
  float sum = 0.F;
  float amplitude = 0.5F;
  float scale = 1.F;
  for (int i = 0; i < kOctaves; ++i) {
    sum += amplitude * noise(place * scale);
    amplitude *= 0.5F;
    scale *= kLacunarity;
  }
  // Dense below, wisps above.
  const float wisps = std::clamp((1.F - p.y) * 4.5F * density * sum, 0.F, 1.F);
  return std::clamp(wisps + 2.F * std::max(0.F, 0.5F - p.y), 0.F, 1.F);
}

desc::Vec3i lattice_of(const Cloud& cloud, std::uint64_t most_points) {
  const Vec3 wanted = wanted_cells(cloud);
  int most_cells = kMostCells;
  while (most_cells > 1 && product(lattice_within(wanted, most_cells)) > most_points) --most_cells;
  return lattice_within(wanted, most_cells);
}

bool is_finer_than_grids(const Cloud& cloud, std::uint64_t most_points) {
  const Vec3 wanted = wanted_cells(cloud);
  const desc::Vec3i points = lattice_of(cloud, most_points);
  for (int i = 0; i < 3; ++i) {
    if (!(wanted[i] <= static_cast<float>(points[i] - 1))) return true;
  }
  return false;
}

desc::DensityGrid tabulate(const Cloud& cloud, std::uint64_t most_points) {
  desc::DensityGrid grid;
  grid.points = desc::DensityGrid::Points::Corners;
  grid.border = desc::DensityGrid::Border::Clamp;
  grid.resolution = lattice_of(cloud, most_points);
  const desc::Vec3i& n = grid.resolution;
  const Vec3 step = (cloud.high - cloud.low) / Vec3(n - desc::Vec3i(1));
  const auto row = static_cast<std::size_t>(n.x);
  const std::size_t layer = row * static_cast<std::size_t>(n.y);
  grid.values.resize(layer * static_cast<std::size_t>(n.z));
  parallel_for(static_cast<std::size_t>(n.z), [&](std::size_t z) {
    for (std::size_t i = 0; i < layer; ++i) {
      const Vec3 point(static_cast<float>(i % row), static_cast<float>(i / row),
                       static_cast<float>(z));
      grid.values[z * layer + i] = cloud.at(cloud.low + step * point);
    }
  });
  return grid;
}

CloudGrids::Key CloudGrids::key_of(const Cloud& cloud) {
  const std::array<float, 9> parameters = {
      cloud.density, cloud.wispiness, cloud.frequency, cloud.low.x,  cloud.low.y,
      cloud.low.z,   cloud.high.x,    cloud.high.y,    cloud.high.z,
  };
  return std::bit_cast<Key>(parameters);
}

desc::DensityGridPointer CloudGrids::get(const Cloud& cloud, const SourceLocation& where,
                                         const std::string& name, Warnings& warnings) {
  const auto [entry, is_new] = made_.try_emplace(key_of(cloud));
  Entry& made = entry->second;
  if (is_new) {
    const std::uint64_t most_points = points_left_ / 2;
    const std::uint64_t points = product(lattice_of(cloud, most_points));
    if (const std::string preparation_cut = memory_shortage(sizeof(float) * points);
        !preparation_cut.empty()) {
      throw SceneError(where, "the grid of this cloud " + preparation_cut);
    }
    made.is_coarse = is_finer_than_grids(cloud, most_points);
    made.grid = make_grid(tabulate(cloud, most_points), where, name, warnings);
    points_left_ -= std::min(points, points_left_);
  }
  if (made.is_coarse) {
    warnings.add(kCloud, where,
                 "the noise of this cloud is finer than the grids that are made of it: a coarser "
                 "one stands in",
                 printable(name));
  }
  return made.grid;
}

}  // namespace ajar::pbrt
