#include "import/import.h"

#include <memory>

#include "core/file_extension.h"
#include "import/pbrt/pbrt_import.h"

namespace ajar {

desc::SceneDesc import_scene(const std::string& path, Warnings& warnings) {
  const std::string extension = file_extension(path);
  if (extension == ".pbrt") return import_pbrt(path, warnings);
  throw SceneError({std::make_shared<const std::string>(path), 0, 0},
                   "unknown kind of scene file \"" + extension + "\" (valid: .pbrt)");
}

}  // namespace ajar
