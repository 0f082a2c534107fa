#include "import/gltf/gltf_import.h"

#include <filesystem>

#include "import/common/printable.h"
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
constexpr WarningKind kRepeated{Effect::Slight, "members stand twice: the last counts"};
constexpr WarningKind kVariants{Effect::None, "variants of materials are not shown"};

void warn_of_repeated_members(const gltf::Document& document, Warnings& warnings) {
  for (const gltf::JsonPlaces::Repeated& repeated : document.origin->places.repeated()) {
    const gltf::Element holder(document.json, document.origin, repeated.pointer);
    const std::string name = printable(repeated.name);
    warnings.add(kRepeated, holder.where(),
                 "\"" + name + "\" stands twice in this object: the last counts", name);
  }
  if (const std::size_t more = document.origin->places.more_repeated(); more > 0) {
    warnings.add(kRepeated, document.root().where(),
                 std::to_string(more) + " more members stand twice: the last of each counts");
  }
}

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
  if (const auto variants = root.extension("KHR_materials_variants")) {
    warnings.add(kVariants, variants->where(),
                 "of the variants of materials, only the default is shown");
  }
}

desc::SceneDesc import_bytes(const SceneFile& file, Warnings& warnings, FileAccess& files) {
  const gltf::Document document = gltf::parse_document(file.bytes, file.name);
  const gltf::Element root = document.root();
  desc::SceneDesc scene;
  scene.source = file.name;
  gltf::Context context{scene, warnings, files, document, file.path};
  gltf::check_extensions(root, warnings);
  gltf::check_members(root, warnings);
  warn_of_repeated_members(document, warnings);
  warn_of_the_whole(root, warnings);
  const std::vector<gltf::PlacedNode> nodes = gltf::place_nodes(root);
  gltf::MeshPlacer(context).place(nodes);
  gltf::add_lights(context, nodes);
  const SceneParts parts{.has_camera = gltf::set_camera(context, nodes),
                         .has_lights = !scene.lights.empty()};
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
