#include "import/gltf/gltf_import.h"

#include <algorithm>
#include <filesystem>

#include "import/common/repeated_members.h"
#include "import/common/scene_file.h"
#include "import/common/studio.h"
#include "import/gltf/cameras.h"
#include "import/gltf/extensions.h"
#include "import/gltf/lights.h"
#include "import/gltf/members.h"
#include "import/gltf/mesh_placer.h"

namespace ajar {
namespace {

constexpr WarningKind kAnimations{Effect::Geometry,
                                  "animations are not played: all is shown as it is placed"};
constexpr WarningKind kOtherScenes{Effect::None, "files have several scenes: one is shown"};
constexpr WarningKind kStudioLight{Effect::Light,
                                   "scenes without lights have the light of a studio"};
constexpr WarningKind kVariants{Effect::None, "variants of materials are not shown"};

void warn_of_the_whole(const gltf::Element& root, Warnings& warnings) {
  if (const auto scenes = root.find("scenes"); scenes && scenes->size() > 1) {
    warnings.add(kOtherScenes, scenes->where(),
                 "of these " + std::to_string(scenes->size()) + " scenes only number " +
                     std::to_string(root.find_index("scene", scenes->size()).value_or(0)) +
                     ", counted from 0, is shown");
  }
  if (const auto animations = root.find("animations"); animations && animations->size() > 0) {
    warnings.add(kAnimations, animations->where(),
                 "animations are not played: all is shown as its nodes place it");
  }
  if (const auto variants = gltf::extension_of(root, "KHR_materials_variants")) {
    warnings.add(kVariants, variants->where(),
                 "of the variants of materials, only the default is shown");
  }
}

/// Emissive images are mostly dark but for a few pixels: they are no lamps, unless the file makes
/// them brighter than an image can be. Unlit surfaces are lamps, as they are black otherwise.
bool is_lamp(const desc::SceneDesc& scene, const desc::Shape& shape) {
  const desc::Node& emission = shape.emission->node;
  const Vec3& scale = emission.color("scale");
  const desc::Node& material = scene.materials[static_cast<std::size_t>(shape.material)].node;
  const bool is_unlit =
      material.is("diffuse") && material.get("reflectance") == desc::Value(Vec3(0.F));
  return !std::holds_alternative<desc::TextureRef>(emission.get("radiance")) || is_unlit ||
         std::max({scale.x, scale.y, scale.z}) > 1.F;
}

bool has_lamps(const desc::SceneDesc& scene) {
  return std::any_of(scene.shapes.begin(), scene.shapes.end(), [&](const desc::Shape& shape) {
    return shape.emission && is_lamp(scene, shape);
  });
}

/// Before the studio has come to the scene.
void warn_of_dark_lamps(const gltf::Element& root, const desc::SceneDesc& scene,
                        Warnings& warnings) {
  const auto shines = [](const desc::Shape& shape) { return shape.emission.has_value(); };
  if (std::none_of(scene.shapes.begin(), scene.shapes.end(), shines)) return;
  warnings.add(kStudioLight, root.where(),
               "there are no lights, and what shines has images of it, which may be dark: the "
               "light of a studio is added");
}

desc::SceneDesc import_bytes(const SceneFile& file, Warnings& warnings, FileAccess& files) {
  const gltf::Document document = gltf::parse_document(file.bytes, file.name);
  const gltf::Element root = document.root;
  desc::SceneDesc scene;
  scene.source = file.name;
  gltf::Context context{scene, warnings, files, document, file.path};
  gltf::check_extensions(root, warnings);
  gltf::check_members(root, warnings);
  warn_of_repeated_members(root, "last", warnings);
  warn_of_the_whole(root, warnings);
  const std::vector<gltf::PlacedNode> nodes = gltf::place_nodes(root);
  gltf::MeshPlacer(context).place(nodes);
  gltf::add_lights(context, nodes);
  const SceneParts parts{.has_camera = gltf::set_camera(context, nodes),
                         .has_lights = !scene.lights.empty(),
                         .has_lamps = has_lamps(scene)};
  if (parts.has_camera && !parts.has_lights && !parts.has_lamps)
    warn_of_dark_lamps(root, scene, warnings);
  add_studio(scene, parts, UpAxis::Y);
  return scene;
}

}  // namespace

desc::SceneDesc import_gltf(const std::string& path, Warnings& warnings,
                            const FileProvider& provider) {
  return read_scene_file(path, warnings, provider, import_bytes);
}

desc::SceneDesc import_gltf_bytes(std::string_view bytes, const std::string& name,
                                  const std::string& base_folder, Warnings& warnings,
                                  FileProvider provider) {
  return read_scene_bytes(bytes, name, base_folder, warnings, std::move(provider), import_bytes);
}

}  // namespace ajar
