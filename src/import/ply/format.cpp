#include "import/format.h"

#include "import/common/bare_mesh.h"
#include "import/mesh/ply.h"

namespace ajar::ply {
namespace {

desc::SceneDesc read_bytes(const SceneFile& file, Warnings& warnings, FileAccess& /*files*/) {
  return scene_of_mesh(read_ply(file.bytes, file.name), file, warnings, UpAxis::Y);
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
