#include "import/pbrt/mean_color.h"

#include <vector>

namespace ajar::pbrt {
namespace {

constexpr Vec3 kUnknownMean(0.5F);

struct Means {
  ImageWriter& images;
  std::vector<Vec3> of_texture;

  Vec3 of(const desc::Value& value) const {
    if (const auto* texture = std::get_if<desc::TextureRef>(&value)) {
      return of_texture[static_cast<std::size_t>(texture->id)];
    }
    if (const float* number = std::get_if<float>(&value)) return Vec3(*number);
    const Vec3* color = std::get_if<Vec3>(&value);
    return color == nullptr ? kUnknownMean : *color;
  }
  Vec3 of(const desc::Node& node) const {
    if (node.is("constant")) return of(node.get("value"));
    if (node.is("image")) return images.mean(node).value_or(Vec3(1.F));
    if (node.is("dots")) return (of(node.get("inside")) + of(node.get("outside"))) * 0.5F;
    if (!node.has("first") || !node.has("second")) return kUnknownMean;
    const Vec3 first = of(node.get("first"));
    const Vec3 second = of(node.get("second"));
    if (node.is("product")) return first * second;
    const Vec3 amount = node.has("amount") ? of(node.get("amount")) : Vec3(0.5F);
    return first * (Vec3(1.F) - amount) + second * amount;
  }
};

}  // namespace

Vec3 mean_color(const desc::SceneDesc& scene, ImageWriter& images, desc::TextureId id) {
  const std::size_t count = static_cast<std::size_t>(id) + 1;
  // Textures refer to earlier ones only: backwards, what is needed; forwards, its means.
  std::vector<bool> is_needed(count);
  is_needed[count - 1] = true;
  for (std::size_t i = count; i-- > 0;) {
    if (!is_needed[i]) continue;
    for (const desc::Value& value : scene.textures[i].node.values()) {
      if (const auto* texture = std::get_if<desc::TextureRef>(&value)) {
        is_needed[static_cast<std::size_t>(texture->id)] = true;
      }
    }
  }
  Means means{images, std::vector<Vec3>(count, kUnknownMean)};
  for (std::size_t i = 0; i < count; ++i) {
    if (is_needed[i]) means.of_texture[i] = means.of(scene.textures[i].node);
  }
  return means.of_texture[count - 1];
}

}  // namespace ajar::pbrt
