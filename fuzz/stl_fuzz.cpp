// Any bytes must either be a mesh or raise one of our errors.
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "import/mesh/validate_mesh.h"
#include "import/stl/stl.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<ajar::Warning> remarks;
  try {
    ajar::desc::Mesh mesh =
        ajar::read_stl({reinterpret_cast<const char*>(data), size}, "fuzz.stl").mesh;
    ajar::validate_mesh(mesh, {}, remarks);
  } catch (const ajar::SceneError&) {
  }
  return 0;
}
