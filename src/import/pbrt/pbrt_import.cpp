#include "import/pbrt/pbrt_import.h"

#include <filesystem>

#include "import/pbrt/parser.h"

namespace ajar {
namespace {

desc::SceneDesc import_text(std::string_view text, const std::string& name, const std::string& path,
                            const std::string& base_folder, Warnings& warnings,
                            FileProvider provider) {
  FileAccess files(base_folder, std::move(provider), warnings);
  const FileBytes in_text = in_utf8(FileBytes(text));
  const pbrt::DialectChoice choice = pbrt::tell_dialect(in_text.view(), name, files);
  pbrt::SceneBuilder builder(files, name, choice, warnings);
  const SourceLocation end =
      pbrt::Parser(files, builder, warnings).parse(in_text.view(), name, path);
  desc::SceneDesc scene = builder.finish(end);
  scene.files = files.named();
  return scene;
}

}  // namespace

desc::SceneDesc import_pbrt(const std::string& path, Warnings& warnings,
                            const FileProvider& provider) {
  if (const auto text = provider ? provider(path) : std::nullopt) {
    const std::string folder = std::filesystem::path(path).parent_path().string();
    return import_pbrt_text(*text, path, folder, warnings, provider);
  }
  const FileBytes bytes = read_file(path);
  const std::filesystem::path absolute = std::filesystem::absolute(path).lexically_normal();
  desc::SceneDesc scene = import_text(bytes.view(), path, absolute.string(),
                                      absolute.parent_path().string(), warnings, provider);
  scene.files.insert(absolute.string());
  return scene;
}

desc::SceneDesc import_pbrt_text(std::string_view text, const std::string& name,
                                 const std::string& base_folder, Warnings& warnings,
                                 FileProvider provider) {
  const std::string path = (std::filesystem::path(base_folder) / name).lexically_normal().string();
  return import_text(text, name, path, base_folder, warnings, std::move(provider));
}

}  // namespace ajar
