#include "session/scenes/scene_file.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <string_view>

#include "import/import.h"
#include "session/scenes/builtin_scenes.h"

namespace ajar {

namespace {

constexpr std::string_view kBuiltin = "builtin:";

desc::SceneDesc load_builtin(const std::string& name, Warnings& warnings,
                             const SceneDefinitions& definitions) {
  const EmbeddedFile* file = builtin_scene(name);
  if (file == nullptr) {
    throw UsageError(unknown_name_message("built-in scene", name, builtin_scene_names()));
  }
  const std::string path = std::string(kBuiltin) + name + "/" + std::string(file->path);
  desc::SceneDesc scene = import_scene(
      path, warnings, [name](const std::string& wanted) { return builtin_file(name, wanted); },
      definitions);
  // The file must name a method to have a depth: one that its format has, for those who convert
  // the scene. Here it would hide the program's own choice.
  scene.hints.integrator.clear();
  return scene;
}

void check_readable(const std::string& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw IoError(path + ": no such file");
  if (std::filesystem::is_directory(status)) {
    throw IoError(path + ": is a folder, not a scene file");
  }
}

}  // namespace

desc::SceneDesc load_scene(const std::string& scene, Warnings& warnings,
                           const SceneDefinitions& definitions) {
  if (scene.starts_with(kBuiltin)) {
    return load_builtin(scene.substr(kBuiltin.size()), warnings, definitions);
  }
  check_readable(scene);
  return import_scene(scene, warnings, {}, definitions);
}

std::string hash_of_scene(const std::string& scene) {
  Warnings ignored;
  return fmt::format("{:016x}", desc::hash(load_scene(scene, ignored)));
}

std::string absolute_scene(const std::string& scene) {
  if (scene.starts_with(kBuiltin)) return scene;
  std::error_code error;
  const std::filesystem::path path = std::filesystem::absolute(scene, error);
  return error ? scene : path.lexically_normal().string();
}

std::string scene_stem(const std::string& scene) {
  if (scene.starts_with(kBuiltin)) return scene.substr(kBuiltin.size());
  const std::filesystem::path path = std::filesystem::absolute(scene).lexically_normal();
  const std::string stem = path.stem().string();
  std::string folder = path.parent_path().filename().string();
  if (stem == "scene" && !folder.empty()) return folder;
  return stem.empty() ? "picture" : stem;
}

}  // namespace ajar
