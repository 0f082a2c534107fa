#include "import/format.h"

#include "import/mitsuba/mitsuba_import.h"

namespace ajar::mitsuba {
namespace {

desc::SceneDesc read(const std::string& path, Warnings& warnings, const FileProvider& provider) {
  return import_mitsuba(path, warnings, provider);
}

}  // namespace

Format format() {
  return {.name = "mitsuba",
          .summary = "scenes of Mitsuba 0.5, 0.6, 2 and 3",
          .extensions = {".xml"},
          .read = read};
}

}  // namespace ajar::mitsuba
