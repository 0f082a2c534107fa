#include "integrator/regions/surface_edges.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ajar {

namespace {

/// Calls `use(i, j)` with the indices of all pairs of pixels that share an edge.
template <typename Use>
void for_each_pair(Vec2i size, const Use& use) {
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const auto width = static_cast<std::size_t>(size.x);
      const std::size_t i = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
      if (x + 1 < size.x) use(i, i + 1);
      if (y + 1 < size.y) use(i, i + width);
    }
  }
}

/// Relative to the nearer; 0 if one of them is unknown.
float depth_step(float a, float b) {
  const auto known = [](float depth) { return std::isfinite(depth) && depth > 0.F; };
  return known(a) && known(b) ? std::abs(a - b) / std::min(a, b) : 0.F;
}

/// Radians; 0 if one of them has no direction.
float angle_between(std::span<const float> normals, std::size_t i, std::size_t j) {
  const auto normal = [&](std::size_t pixel) {
    return Vec3(normals[3 * pixel], normals[3 * pixel + 1], normals[3 * pixel + 2]);
  };
  const Vec3 a = normal(i);
  const Vec3 b = normal(j);
  // Exact for small angles, too; 0 for a normal of length 0.
  const float angle = std::atan2(length(cross(a, b)), dot(a, b));
  return std::isfinite(angle) ? angle : 0.F;
}

float edge_between(const SurfacePicture& picture, const EdgeLimits& limits, std::size_t i,
                   std::size_t j) {
  if (picture.identities[i] != picture.identities[j]) return 1.F;
  if (picture.identities[i] == PixelIdentity()) return 0.F;
  float edge = 0.F;
  if (!picture.depths.empty()) {
    edge = depth_step(picture.depths[i], picture.depths[j]) / limits.depth_step;
  }
  if (!picture.normals.empty()) {
    edge = std::max(edge, angle_between(picture.normals, i, j) / limits.normal_angle);
  }
  return std::min(edge, 1.F);
}

}  // namespace

Plane surface_edges(const SurfacePicture& picture, const EdgeLimits& limits) {
  Plane edges(picture.size);
  const std::size_t count = edges.values.size();
  if (picture.identities.size() != count ||
      (!picture.depths.empty() && picture.depths.size() != count) ||
      (!picture.normals.empty() && picture.normals.size() != 3 * count)) {
    throw std::invalid_argument("edges: the layers do not have the picture's size");
  }
  if (!(limits.depth_step > 0.F && limits.normal_angle > 0.F)) {
    throw std::invalid_argument("edges: the limits are not positive");
  }
  for_each_pair(picture.size, [&](std::size_t i, std::size_t j) {
    const float edge = edge_between(picture, limits, i, j);
    edges.values[i] = std::max(edges.values[i], edge);
    edges.values[j] = std::max(edges.values[j], edge);
  });
  return edges;
}

Plane edges_of_map(const Plane& edges, const Plane& map) {
  if (edges.size != map.size) throw std::invalid_argument("edges: the map has another size");
  Plane result(edges.size);
  for_each_pair(edges.size, [&](std::size_t i, std::size_t j) {
    if (map.values[i] == map.values[j]) return;
    result.values[i] = edges.values[i];
    result.values[j] = edges.values[j];
  });
  return result;
}

}  // namespace ajar
