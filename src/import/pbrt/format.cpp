#include "import/format.h"

#include "import/pbrt/pbrt_import.h"
#include "import/pbrt/pbrt_writer.h"

namespace ajar::pbrt {

Format format() {
  return {.name = "pbrt",
          .summary =
              "scenes of pbrt-v3 and pbrt-v4; written as pbrt-v3, meshes as binary PLY in a folder "
              "beside",
          .extensions = {".pbrt"},
          .read = import_pbrt,
          .write = write_pbrt};
}

}  // namespace ajar::pbrt
