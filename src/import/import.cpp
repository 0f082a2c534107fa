#include "import/import.h"

#include "core/error.h"
#include "import/format.h"

namespace ajar {

desc::SceneDesc import_scene(const std::string& path, Warnings& warnings,
                             const FileProvider& provider, const SceneDefinitions& definitions) {
  const Format& format = format_of(path);
  if (definitions.empty()) return format.read(path, warnings, provider);
  if (format.read_defined == nullptr) {
    throw UsageError("-D" + definitions.begin()->first + ": scenes of the format " + format.name +
                     " have no parameters to define");
  }
  return format.read_defined(path, warnings, provider, definitions);
}

}  // namespace ajar
