#include "import/common/opacity.h"

#include <algorithm>
#include <utility>

#include "scene/desc/models.h"

namespace ajar {
namespace {

desc::MaterialId add(desc::SceneDesc& scene, const desc::Material& like, desc::Node node) {
  desc::Material made{.name = like.name, .where = like.where, .node = std::move(node)};
  scene.materials.push_back(std::move(made));
  return static_cast<desc::MaterialId>(scene.materials.size()) - 1;
}

}  // namespace

desc::Node clear_material(Passing passing) {
  return desc::material_node("composite", {{"diffuse_reflectance", Vec3(0.F)},
                                           {"glossy_reflectance", Vec3(0.F)},
                                           {"opacity", Vec3(0.F)},
                                           {"uncounted", passing == Passing::Uncounted}});
}

desc::MaterialId part_of_mix(desc::SceneDesc& scene, desc::MaterialId id, Passing passing) {
  const desc::Material& part = scene.materials[static_cast<std::size_t>(id)];
  return part.node.is("interface") ? add(scene, part, clear_material(passing)) : id;
}

PartlyClear with_opacity(desc::SceneDesc& scene, const desc::Material& like,
                         desc::MaterialId visible, const desc::Value& opacity, Passing passing) {
  desc::Value amount = opacity;
  if (const float* number = std::get_if<float>(&opacity)) {
    amount = Vec3(std::clamp(*number, 0.F, 1.F));
  }
  PartlyClear result;
  if (const auto* texture = std::get_if<desc::TextureRef>(&opacity)) result.alpha = texture->id;
  const desc::MaterialId clear = add(scene, like, clear_material(passing));
  result.material = add(scene, like,
                        desc::material_node("mix", {{"amount", amount},
                                                    {"first", desc::MaterialRef{visible}},
                                                    {"second", desc::MaterialRef{clear}}}));
  return result;
}

}  // namespace ajar
