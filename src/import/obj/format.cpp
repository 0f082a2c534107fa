#include "import/format.h"

#include "import/obj/obj_import.h"

namespace ajar::obj {

Format format() {
  return {.name = "obj",
          .summary = "meshes of Wavefront, with their materials (.mtl), shown in a studio",
          .extensions = {".obj"},
          .read = import_obj};
}

}  // namespace ajar::obj
