#include "import/mitsuba/mitsuba_import.h"

#include <filesystem>

#include "import/mitsuba/parser.h"
#include "import/mitsuba/scene_builder.h"

namespace ajar {
namespace {

/// `path` identifies the file among those it includes.
desc::SceneDesc import_text(std::string_view text, const std::string& name, const std::string& path,
                            const std::string& base_folder, Warnings& warnings,
                            FileProvider provider, const SceneDefinitions& definitions) {
  FileAccess files(base_folder, std::move(provider), warnings);
  mitsuba::SearchPath search(files);
  const mitsuba::Document document =
      mitsuba::Parser(search, warnings, definitions).parse(text, name, path);
  desc::SceneDesc scene = mitsuba::build_scene(document, search, warnings);
  scene.source = name;
  scene.files = files.named();
  return scene;
}

}  // namespace

desc::SceneDesc import_mitsuba(const std::string& path, Warnings& warnings,
                               const FileProvider& provider, const SceneDefinitions& definitions) {
  if (const auto text = provider ? provider(path) : std::nullopt) {
    const std::string folder = std::filesystem::path(path).parent_path().string();
    return import_mitsuba_text(*text, path, folder, warnings, provider, definitions);
  }
  const FileBytes bytes = read_file(path);
  const std::filesystem::path absolute = std::filesystem::absolute(path).lexically_normal();
  desc::SceneDesc scene =
      import_text(bytes.view(), path, absolute.string(), absolute.parent_path().string(), warnings,
                  provider, definitions);
  scene.files.insert(absolute.string());
  return scene;
}

desc::SceneDesc import_mitsuba_text(std::string_view text, const std::string& name,
                                    const std::string& base_folder, Warnings& warnings,
                                    FileProvider provider, const SceneDefinitions& definitions) {
  const std::string path = (std::filesystem::path(base_folder) / name).lexically_normal().string();
  return import_text(text, name, path, base_folder, warnings, std::move(provider), definitions);
}

}  // namespace ajar
