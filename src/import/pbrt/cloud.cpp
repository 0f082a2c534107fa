#include "import/pbrt/cloud.h"

#include <algorithm>
#include <cmath>

#include "core/noise.h"
#include "core/parallel_for.h"

namespace ajar::pbrt {
namespace {

constexpr float kLacunarity = 1.99F;
constexpr int kOctaves = 5;
constexpr int kMostCells = 255;  ///< along an axis: 64 MB

/// Gradient of the noise, by differences.
Vec3 slope_of_noise(const Vec3& p) {
  constexpr float kStep = 0.01F;
  const float here = noise(p);
  return Vec3(noise(p + Vec3(kStep, 0, 0)) - here, noise(p + Vec3(0, kStep, 0)) - here,
              noise(p + Vec3(0, 0, kStep)) - here) /
         kStep;
}

/// That the finest noise asks for along the axes.
Vec3 wanted_cells(const Cloud& cloud) {
  const float finest = cloud.frequency * std::pow(kLacunarity, static_cast<float>(kOctaves - 1));
  Vec3 cells = (cloud.high - cloud.low) * (2.F * finest);
  for (int i = 0; i < 3; ++i) cells[i] = std::ceil(std::abs(cells[i]));
  return cells;
}

/// Of the lattice that is made, along the axes.
desc::Vec3i cells_of(const Cloud& cloud) {
  const Vec3 wanted = wanted_cells(cloud);
  desc::Vec3i cells;
  for (int i = 0; i < 3; ++i) {
    // What is no number asks for one cell.
    cells[i] = static_cast<int>(
        std::clamp(wanted[i] >= 1.F ? wanted[i] : 1.F, 1.F, static_cast<float>(kMostCells)));
  }
  return cells;
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

bool is_finer_than_grids(const Cloud& cloud) {
  const Vec3 cells = wanted_cells(cloud);
  return !(std::max({cells.x, cells.y, cells.z}) <= static_cast<float>(kMostCells));
}

std::uint64_t grid_bytes(const Cloud& cloud) {
  const desc::Vec3i cells = cells_of(cloud);
  std::uint64_t bytes = sizeof(float);
  for (int i = 0; i < 3; ++i) bytes *= static_cast<std::uint64_t>(cells[i]) + 1;
  return bytes;
}

desc::DensityGrid tabulate(const Cloud& cloud) {
  desc::DensityGrid grid;
  grid.points = desc::DensityGrid::Points::Corners;
  grid.border = desc::DensityGrid::Border::Clamp;
  const desc::Vec3i cells = cells_of(cloud);
  Vec3 step(0.F);
  for (int i = 0; i < 3; ++i) {
    grid.resolution[i] = cells[i] + 1;
    step[i] = (cloud.high[i] - cloud.low[i]) / static_cast<float>(cells[i]);
  }
  const desc::Vec3i& n = grid.resolution;
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

}  // namespace ajar::pbrt
