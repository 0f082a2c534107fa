// Any bytes must either be a mesh or raise one of our errors; meshes must survive being written.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "import/mesh/ply.h"
#include "import/mesh/validate_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<ajar::Warning> remarks;
  try {
    ajar::desc::Mesh mesh = ajar::read_ply({reinterpret_cast<const char*>(data), size}, "fuzz.ply");
    ajar::validate_mesh(mesh, {}, remarks);
    const ajar::desc::Mesh copy = ajar::read_ply(ajar::write_ply(mesh), "copy.ply");
    if (copy.positions != mesh.positions || copy.indices != mesh.indices) std::abort();
  } catch (const ajar::SceneError&) {
  }
  return 0;
}
