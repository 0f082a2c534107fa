#include "scene/build/validate.h"

#include <algorithm>
#include <functional>

#include "scene/desc/models.h"

namespace ajar {

namespace {

[[noreturn]] void refuse(const char* kind, const SourceLocation& where) {
  throw SceneError(where, std::string("this refers to a ") + kind + " that does not exist");
}

void check(int id, std::size_t count, const char* kind, const SourceLocation& where) {
  if (id >= static_cast<int>(count) || id < desc::kNone) refuse(kind, where);
}

void check_node(const desc::SceneDesc& scene, const desc::Node& node, const SourceLocation& where) {
  for (const desc::Value& value : node.values()) {
    const auto* texture = std::get_if<desc::TextureRef>(&value);
    if (texture == nullptr) continue;
    if (texture->id == desc::kNone) refuse("texture", where);
    check(texture->id, scene.textures.size(), "texture", where);
  }
}

void check_shape(const desc::SceneDesc& scene, const desc::Shape& shape) {
  check(shape.material, scene.materials.size(), "material", shape.where);
  check(shape.alpha, scene.textures.size(), "texture", shape.where);
  check(shape.shadow_alpha, scene.textures.size(), "texture", shape.where);
  check(shape.inside, scene.media.size(), "medium", shape.where);
  check(shape.outside, scene.media.size(), "medium", shape.where);
  check_node(scene, shape.node, shape.where);
  if (shape.emission) check_node(scene, shape.emission->node, shape.emission->where);
}

void for_each_shape(desc::SceneDesc& scene, const std::function<void(desc::Shape&)>& visit) {
  for (desc::Shape& shape : scene.shapes) visit(shape);
  for (desc::Object& object : scene.objects) {
    for (desc::Shape& shape : object.shapes) visit(shape);
  }
}

}  // namespace

void validate_references(const desc::SceneDesc& scene) {
  for (const desc::Shape& shape : scene.shapes) check_shape(scene, shape);
  for (const desc::Object& object : scene.objects) {
    for (const desc::Shape& shape : object.shapes) check_shape(scene, shape);
  }
  for (const desc::Texture& texture : scene.textures) {
    check_node(scene, texture.node, texture.where);
  }
  for (const desc::Material& material : scene.materials) {
    check(material.bump, scene.textures.size(), "texture", material.where);
    check(material.normal_map.texture, scene.textures.size(), "texture", material.where);
    check_node(scene, material.node, material.where);
  }
  for (const desc::Light& light : scene.lights) {
    check(light.medium, scene.media.size(), "medium", light.where);
  }
  for (const desc::Instance& instance : scene.instances) {
    check(std::max(instance.object, 0), scene.objects.size(), "object", instance.where);
  }
  for (const desc::Medium& medium : scene.media) {
    if (!medium.density) continue;
    const std::optional<std::string> complaint = desc::complaint(*medium.density);
    if (complaint) throw SceneError(medium.where, "the medium " + *complaint);
  }
  check(scene.camera.medium, scene.media.size(), "medium", scene.camera.where);
}

void add_default_material(desc::SceneDesc& scene) {
  desc::MaterialId added = desc::kNone;
  for_each_shape(scene, [&](desc::Shape& shape) {
    if (shape.material != desc::kNone) return;
    if (added == desc::kNone) {
      scene.materials.emplace_back().node =
          desc::material_node("diffuse", {{"reflectance", Vec3(0.5F)}});
      added = static_cast<desc::MaterialId>(scene.materials.size()) - 1;
    }
    shape.material = added;
  });
}

}  // namespace ajar
