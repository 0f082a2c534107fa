#include "session/scenes/builtin_scenes.h"

#include <algorithm>
#include <filesystem>

namespace ajar {

namespace {

std::string normal_path(std::string_view scene, std::string_view path) {
  const std::string base = "builtin:" + std::string(scene) + "/";
  if (path.starts_with(base)) path.remove_prefix(base.size());
  return std::filesystem::path(path).lexically_normal().generic_string();
}

bool is_scene(const EmbeddedFile& file) {
  return std::filesystem::path(file.path).replace_extension() == "scene";
}

}  // namespace

std::vector<std::string> builtin_scene_names() {
  std::vector<std::string> names;
  for (const EmbeddedFile& file : embedded_files()) {
    if (is_scene(file)) names.emplace_back(file.scene);
  }
  return names;
}

const EmbeddedFile* builtin_scene(std::string_view scene) {
  for (const EmbeddedFile& file : embedded_files()) {
    if (file.scene == scene && is_scene(file)) return &file;
  }
  return nullptr;
}

std::string builtin_scene_summary(std::string_view scene) {
  const EmbeddedFile* file = builtin_scene(scene);
  std::string_view text = file == nullptr ? std::string_view() : file->bytes;
  std::string comment;
  while (text.starts_with('#')) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    comment.append(text.substr(1, end - 1));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  const std::string name = " " + std::string(scene) + ":";
  std::string_view sentence = comment;
  if (sentence.starts_with(name)) sentence.remove_prefix(name.size());
  while (sentence.starts_with(' ')) sentence.remove_prefix(1);
  return std::string(sentence.substr(0, sentence.find(". ")));
}

std::optional<std::string_view> builtin_file(std::string_view scene, std::string_view path) {
  const std::string wanted = normal_path(scene, path);
  for (const EmbeddedFile& file : embedded_files()) {
    if (file.scene == scene && file.path == wanted) return file.bytes;
  }
  return std::nullopt;
}

}  // namespace ajar
