#include "import/tungsten/tungsten_import.h"

#include <filesystem>
#include <utility>

#include "import/common/repeated_members.h"
#include "import/tungsten/camera.h"
#include "import/tungsten/other_dialects.h"
#include "import/tungsten/primitives.h"
#include "import/tungsten/settings.h"

namespace ajar {
namespace tungsten {
namespace {

constexpr WarningKind kNoCamera{Effect::Light, "scenes have no camera"};
constexpr WarningKind kNoShapes{Effect::Geometry, "scenes have no shapes"};

void read_scene(Context& context, const LocatedJson& root) {
  require_scene(root);
  const ObjectReader object(context, root, "a scene");
  // First: how long paths are matters to media.
  if (const auto integrator = object.find("integrator")) {
    read_integrator(context, *integrator);
  }
  TextureReader textures(context);
  MediumTable media(context);
  BsdfTable bsdfs(context, textures);
  PrimitiveReader primitives(context, textures, bsdfs, media);
  if (const auto list = object.find("media")) media.define(*list);
  if (const auto list = object.find("bsdfs")) bsdfs.define(*list);
  if (const auto list = object.find("primitives")) primitives.read_all(*list);
  if (!primitives.has_light()) add_default_light(context, root.where());
  if (const auto camera = object.find("camera")) {
    read_camera(context, *camera, media, primitives.places());
  } else {
    context.warnings.add(kNoCamera, root.where(),
                         "there is no \"camera\": a perspective one at the origin is used");
    context.scene.camera.where = context.scene.film.where = root.where();
  }
  if (const auto renderer = object.find("renderer")) read_renderer(context, *renderer);
  object.report_unknown();
  if (context.scene.shapes.empty() && context.scene.instances.empty()) {
    context.warnings.add(kNoShapes, root.where(), "there are no shapes in this scene");
  }
}

}  // namespace
}  // namespace tungsten

desc::SceneDesc import_tungsten_text(std::string_view text, const std::string& name,
                                     const std::string& base_folder, Warnings& warnings,
                                     FileProvider provider) {
  FileAccess files(base_folder, std::move(provider), warnings);
  const FileBytes in_text = in_utf8(FileBytes(text));
  desc::SceneDesc scene;
  scene.source = name;
  tungsten::Context context{scene, warnings, files};
  // Bsdfs and textures are read recursively.
  const JsonRules rules{.name = name, .deepest = 100, .first_counts = true, .has_extras = true};
  const LocatedJson root = LocatedJson::parse(std::string(in_text.view()), rules);
  warn_of_repeated_members(root, "first", warnings);
  tungsten::read_scene(context, root);
  scene.files = files.named();
  return scene;
}

desc::SceneDesc import_tungsten(const std::string& path, Warnings& warnings,
                                const FileProvider& provider) {
  if (const auto text = provider ? provider(path) : std::nullopt) {
    const std::string folder = std::filesystem::path(path).parent_path().string();
    return import_tungsten_text(*text, path, folder, warnings, provider);
  }
  const FileBytes bytes = read_file(path);
  const std::filesystem::path absolute = std::filesystem::absolute(path).lexically_normal();
  desc::SceneDesc scene =
      import_tungsten_text(bytes.view(), path, absolute.parent_path().string(), warnings, provider);
  scene.files.insert(absolute.string());
  return scene;
}

}  // namespace ajar
