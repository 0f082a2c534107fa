#include "import/common/opacity.h"

#include <algorithm>
#include <utility>

#include "scene/desc/models.h"

namespace ajar {
namespace {

desc::MaterialId add(desc::SceneDesc& scene, const desc::Material& like, desc::Node node) {
  scene.materials.push_back({.name = like.name, .where = like.where, .node = std::move(node)});
  return static_cast<desc::MaterialId>(scene.materials.size()) - 1;
}

}  // namespace

desc::Node clear_material() {
  return desc::material_node("composite", {{"diffuse_reflectance", Vec3(0.F)},
                                           {"glossy_reflectance", Vec3(0.F)},
                                           {"opacity", Vec3(0.F)}});
}

PartlyClear with_opacity(desc::SceneDesc& scene, const desc::Material& like,
                         desc::MaterialId visible, const desc::Value& opacity) {
  desc::Value amount = opacity;
  if (const float* number = std::get_if<float>(&opacity)) {
    amount = Vec3(std::clamp(*number, 0.F, 1.F));
  }
  PartlyClear result;
  if (const auto* texture = std::get_if<desc::TextureRef>(&opacity)) result.alpha = texture->id;
  const desc::MaterialId clear = add(scene, like, clear_material());
  result.material = add(scene, like,
                        desc::material_node("mix", {{"amount", amount},
                                                    {"first", desc::MaterialRef{visible}},
                                                    {"second", desc::MaterialRef{clear}}}));
  return result;
}

}  // namespace ajar
