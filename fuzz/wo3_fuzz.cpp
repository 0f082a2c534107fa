// Any bytes must either be a mesh, a list of instances and curves or be refused.
#include <cstddef>
#include <cstdint>

#include "core/error.h"
#include "import/mesh/creased_normals.h"
#include "import/mesh/validate_mesh.h"
#include "import/tungsten/instances.h"
#include "import/tungsten/strands.h"
#include "import/tungsten/wo3.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  ajar::tungsten::read_instance_file(bytes);
  try {
    ajar::tungsten::Wo3Mesh source = ajar::tungsten::read_wo3(bytes, "fuzz.wo3");
    std::vector<ajar::Warning> remarks;
    ajar::validate_mesh(source.mesh, {}, remarks);
    ajar::with_creased_normals(source.mesh, 0.9F);
  } catch (const ajar::SceneError&) {
  }
  for (const char* name : {"fuzz.fiber", "fuzz.hair"}) {
    try {
      ajar::tungsten::curves_of(ajar::tungsten::read_strands(bytes, name),
                                {.radius = {}, .tapers = true});
    } catch (const ajar::SceneError&) {
    }
  }
  return 0;
}
