#include "import/format.h"

#include "import/common/bare_mesh.h"
#include "import/stl/stl.h"

namespace ajar::stl {
namespace {

desc::SceneDesc read_bytes(const SceneFile& file, Warnings& warnings, FileAccess& /*files*/) {
  StlContents contents = read_stl(file.bytes, file.name);
  return scene_of_mesh(std::move(contents.mesh), {.colors = contents.colors}, file, warnings,
                       UpAxis::Z);
}

desc::SceneDesc read(const std::string& path, Warnings& warnings, const FileProvider& provider) {
  return read_scene_file(path, warnings, provider, read_bytes);
}

}  // namespace

Format format() {
  return {.name = "stl",
          .summary = "triangles for printers and machines (z is up), shown in a studio",
          .extensions = {".stl"},
          .read = read};
}

}  // namespace ajar::stl
