#include "import/format.h"

#include "import/tungsten/tungsten_import.h"

namespace ajar::tungsten {

Format format() {
  return {.name = "tungsten",
          .summary = "scenes of Tungsten, with meshes as .wo3 or .obj",
          .extensions = {".json"},
          .read = import_tungsten};
}

}  // namespace ajar::tungsten
