#include "import/import.h"

#include "import/format.h"

namespace ajar {

desc::SceneDesc import_scene(const std::string& path, Warnings& warnings,
                             const FileProvider& provider) {
  return format_of(path).read(path, warnings, provider);
}

}  // namespace ajar
