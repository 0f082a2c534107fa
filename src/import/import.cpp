#include "import/import.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>

#include "import/pbrt/pbrt_import.h"

namespace ajar {

desc::SceneDesc import_scene(const std::string& path, Warnings& warnings) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".pbrt") return import_pbrt(path, warnings);
  throw SceneError({std::make_shared<const std::string>(path), 0, 0},
                   "unknown kind of scene file \"" + extension + "\" (valid: .pbrt)");
}

}  // namespace ajar
