#include "import/format.h"

#include "import/mitsuba/mitsuba_import.h"

namespace ajar::mitsuba {
namespace {

desc::SceneDesc read(const std::string& path, Warnings& warnings, const FileProvider& provider) {
  return import_mitsuba(path, warnings, provider);
}

desc::SceneDesc read_defined(const std::string& path, Warnings& warnings,
                             const FileProvider& provider, const SceneDefinitions& definitions) {
  return import_mitsuba(path, warnings, provider, definitions);
}

}  // namespace

Format format() {
  return {.name = "mitsuba",
          .summary = "scenes of Mitsuba 0.5, 0.6, 2 and 3",
          .extensions = {".xml"},
          .read = read,
          .read_defined = read_defined};
}

}  // namespace ajar::mitsuba
