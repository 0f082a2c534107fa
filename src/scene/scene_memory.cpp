#include "scene/scene_memory.h"

#include <algorithm>
#include <map>
#include <string>
#include <variant>

#include "core/available_memory.h"
#include "scene/shape/loop_subdivision.h"
#include "scene/texture/image_cache.h"

namespace ajar {

namespace {

// Measured: Embree 3.13 keeps 67 bytes per triangle in meshes of 25 000 to 130 000. While it builds
// there are as many again.
constexpr std::uint64_t kTreeBytesPerTriangle = 135;
constexpr std::uint64_t kTreeBytesPerSegment = 300;  // of curves; a bound, not measured
constexpr std::uint64_t kBytesPerVertex = 64;        // of a TriangleMesh with all attributes
constexpr std::uint64_t kBytesPerTriangle = 12;      // its indices
constexpr std::uint64_t kDensityBytesPerTexel = 16;  // of a light's map of directions

std::uint64_t triangle_bytes(std::uint64_t triangles, std::uint64_t vertices) {
  return triangles * (kTreeBytesPerTriangle + kBytesPerTriangle) + vertices * kBytesPerVertex;
}

/// Each level makes four triangles of one; large meshes have half as many vertices. Refining takes
/// less than Embree does afterwards.
std::uint64_t subdivided_bytes(const desc::LoopSubdivision& surface, int levels) {
  const std::uint64_t triangles = std::uint64_t{surface.control.indices.size()}
                                  << 2U * static_cast<unsigned>(levels);
  return triangle_bytes(triangles, triangles / 2);
}

struct ShapeMemory {
  std::uint64_t operator()(const std::shared_ptr<const desc::Mesh>& mesh) const {
    return triangle_bytes(mesh->indices.size(), mesh->positions.size());
  }
  std::uint64_t operator()(const std::shared_ptr<const desc::LoopSubdivision>& surface) const {
    return subdivided_bytes(*surface, possible_levels(*surface));
  }
  std::uint64_t operator()(const std::shared_ptr<const desc::Curve>& curve) const {
    return curve->control_points.size() / 4 * kTreeBytesPerSegment;
  }
  std::uint64_t operator()(const desc::Node& /*quadric*/) const { return 0; }
};

std::uint64_t shape_bytes(const std::vector<desc::Shape>& shapes) {
  std::uint64_t bytes = 0;
  for (const desc::Shape& shape : shapes) {
    using Subdivision = std::shared_ptr<const desc::LoopSubdivision>;
    if (const auto* surface = std::get_if<Subdivision>(&shape.node)) {
      check_subdivision_memory(**surface, shape.where);
    }
    bytes += std::visit(ShapeMemory{}, shape.node);
  }
  return bytes;
}

}  // namespace

void check_subdivision_memory(const desc::LoopSubdivision& surface, const SourceLocation& where) {
  const int levels = possible_levels(surface);
  const std::string shortage = memory_shortage(subdivided_bytes(surface, levels));
  if (shortage.empty()) return;
  int fitting = levels - 1;
  while (fitting > 0 && !memory_shortage(subdivided_bytes(surface, fitting)).empty()) --fitting;
  const std::size_t faces = surface.control.indices.size();
  throw SceneError(where, "this subdivision surface, with " + std::to_string(faces) +
                              (faces == 1 ? " face" : " faces") + " and \"levels\" of " +
                              std::to_string(surface.levels) + ", " + shortage +
                              "; \"levels\" can be at most " +
                              std::to_string(std::max(fitting, 0)));
}

SceneMemory estimate_memory(const desc::SceneDesc& scene) {
  SceneMemory memory;
  memory.geometry = shape_bytes(scene.shapes);
  for (const desc::Object& object : scene.objects) memory.geometry += shape_bytes(object.shapes);

  std::map<std::string, ImageSize> images;
  const auto size_of = [&](const std::string& path) {
    const auto [entry, is_new] = images.try_emplace(path);
    if (is_new) entry->second = image_size(path);
    memory.images += is_new ? entry->second.bytes : 0;
    return entry->second;
  };
  for (const desc::Texture& texture : scene.textures) {
    for (const std::string& path : texture.node.files()) size_of(path);
  }
  for (const desc::Light& light : scene.lights) {
    for (const std::string& path : light.node.files()) {
      if (!path.empty()) memory.images += size_of(path).texels * kDensityBytesPerTexel;
    }
  }
  return memory;
}

}  // namespace ajar
