#include "scene/scene_memory.h"

#include <map>
#include <vector>

#include "scene/medium/medium.h"
#include "scene/shape/build_shape.h"
#include "scene/texture/inputs.h"

namespace ajar {

namespace {

constexpr std::uint64_t kDensityBytesPerTexel = 16;  // bytes of a light's map of directions

std::uint64_t shape_bytes(const std::vector<desc::Shape>& shapes) {
  std::uint64_t bytes = 0;
  for (const desc::Shape& shape : shapes) bytes += shape_memory(shape);
  return bytes;
}

}  // namespace

SceneMemory estimate_memory(const desc::SceneDesc& scene) {
  SceneMemory memory;
  memory.geometry = shape_bytes(scene.shapes);
  for (const desc::Object& object : scene.objects) memory.geometry += shape_bytes(object.shapes);

  std::map<ImageRequest, ImageSize> images;
  const auto size_of = [&](const ImageRequest& request) {
    const auto [entry, is_new] = images.try_emplace(request);
    if (is_new) entry->second = image_size(request, scene.embedded_files);
    memory.images += is_new ? entry->second.bytes : 0;
    return entry->second;
  };
  for (const desc::Texture& texture : scene.textures) {
    for (const ImageRequest& request : image_requests(texture.node)) size_of(request);
  }
  for (const desc::Medium& medium : scene.media) {
    if (medium.density && medium.density->grid) {
      const desc::DensityGrid& grid = *medium.density->grid;
      memory.media += grid.is_colored() ? ColorField::memory(grid) : DensityField::memory(grid);
    }
  }
  for (const desc::Light& light : scene.lights) {
    for (const std::string& path : light.node.files()) {
      if (!path.empty()) memory.images += size_of({path}).texels * kDensityBytesPerTexel;
    }
  }
  return memory;
}

}  // namespace ajar
