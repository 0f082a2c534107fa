#include "session/builtin_scenes.h"

#include <filesystem>

namespace ajar {

namespace {

std::string normal_path(std::string_view scene, std::string_view path) {
  const std::string base = "builtin:" + std::string(scene) + "/";
  if (path.starts_with(base)) path.remove_prefix(base.size());
  return std::filesystem::path(path).lexically_normal().generic_string();
}

}  // namespace

std::vector<std::string> builtin_scene_names() {
  std::vector<std::string> names;
  for (const EmbeddedFile& file : embedded_files()) {
    if (file.path == "scene.pbrt") names.emplace_back(file.scene);
  }
  return names;
}

std::string builtin_scene_summary(std::string_view scene) {
  constexpr std::string_view kMark = "# about:";
  const std::string_view text = builtin_file(scene, "scene.pbrt").value_or("").substr(0, 2000);
  const std::size_t at = text.find(kMark);
  if (at == std::string_view::npos) return {};
  std::string_view line = text.substr(at + kMark.size());
  line = line.substr(0, line.find('\n'));
  while (!line.empty() && line.front() == ' ') line.remove_prefix(1);
  return std::string(line);
}

std::optional<std::string_view> builtin_file(std::string_view scene, std::string_view path) {
  const std::string wanted = normal_path(scene, path);
  for (const EmbeddedFile& file : embedded_files()) {
    if (file.scene == scene && file.path == wanted) return file.bytes;
  }
  return std::nullopt;
}

}  // namespace ajar
