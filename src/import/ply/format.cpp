#include "import/format.h"

#include "import/common/bare_mesh.h"
#include "import/common/printable.h"
#include "import/mesh/ply.h"

namespace ajar::ply {
namespace {

constexpr WarningKind kSkipped{Effect::Slight, "elements and properties of PLY files are not read"};

void warn_of_skipped(const std::vector<std::string>& names, const SceneFile& file,
                     Warnings& warnings) {
  const SourceLocation where{std::make_shared<const std::string>(file.name), 0, 0};
  std::string list;
  for (const std::string& name : names) {
    list += (list.empty() ? "\"" : ", \"") + printable(name) + "\"";
  }
  if (list.empty()) return;
  warnings.add(kSkipped, where, "not read of this file: " + list);
}

desc::SceneDesc read_bytes(const SceneFile& file, Warnings& warnings, FileAccess& /*files*/) {
  PlyContents contents = read_ply_contents(file.bytes, file.name);
  warn_of_skipped(contents.skipped, file, warnings);
  return scene_of_mesh(std::move(contents.mesh), contents.colors, file, warnings, UpAxis::Y);
}

desc::SceneDesc read(const std::string& path, Warnings& warnings, const FileProvider& provider) {
  return read_scene_file(path, warnings, provider, read_bytes);
}

}  // namespace

Format format() {
  return {.name = "ply",
          .summary = "a mesh in Stanford's format, shown in a studio",
          .extensions = {".ply"},
          .read = read};
}

}  // namespace ajar::ply
