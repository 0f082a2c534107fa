#include "import/common/scene_file.h"

#include <filesystem>

namespace ajar {

namespace fs = std::filesystem;

desc::SceneDesc read_scene_file(const std::string& path, Warnings& warnings,
                                const FileProvider& provider, ReadScene read) {
  if (const auto bytes = provider ? provider(path) : std::nullopt) {
    const FileBytes text = in_utf8(FileBytes(*bytes));
    FileAccess files(fs::path(path).parent_path().string(), provider, warnings);
    desc::SceneDesc scene = read({text.view(), path, path}, warnings, files);
    scene.files = files.named();
    return scene;
  }
  const FileBytes bytes = in_utf8(read_file(path));
  const fs::path absolute = fs::absolute(path).lexically_normal();
  FileAccess files(absolute.parent_path().string(), provider, warnings);
  const std::string absolute_path = absolute.string();
  desc::SceneDesc scene = read({bytes.view(), path, absolute_path}, warnings, files);
  scene.files = files.named();
  scene.files.insert(absolute_path);
  return scene;
}

desc::SceneDesc read_scene_bytes(std::string_view bytes, const std::string& name,
                                 const std::string& folder, Warnings& warnings,
                                 FileProvider provider, ReadScene read) {
  const std::string path = (fs::path(folder) / name).lexically_normal().string();
  const FileBytes text = in_utf8(FileBytes(bytes));
  FileAccess files(folder, std::move(provider), warnings);
  desc::SceneDesc scene = read({text.view(), name, path}, warnings, files);
  scene.files = files.named();
  return scene;
}

}  // namespace ajar
