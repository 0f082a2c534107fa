#include "import/format.h"

#include "import/gltf/gltf_import.h"

namespace ajar::gltf {

Format format() {
  return {.name = "gltf",
          .summary = "scenes and models of glTF 2.0; what they lack of camera and lights is added",
          .extensions = {".gltf", ".glb"},
          .read = import_gltf};
}

}  // namespace ajar::gltf
