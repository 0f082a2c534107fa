// Any text must either import or raise one of our errors, as meshes and as materials. Files are
// served from memory; on the disk nothing is found.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/error.h"
#include "import/obj/obj_import.h"

namespace {

/// A mesh whose materials are the input.
constexpr std::string_view kMesh =
    "mtllib self.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\nusemtl b\n"
    "f 1 2 3\n";

void import(std::string_view text, std::string_view input) {
  ajar::Warnings warnings;
  try {
    const ajar::desc::SceneDesc scene =
        ajar::import_obj_text(text, "fuzz.obj", "/nonexistent", warnings,
                              [&](const std::string& path) -> std::optional<std::string_view> {
                                if (path == "/nonexistent/self.mtl") return input;
                                return std::nullopt;
                              });
    ajar::desc::hash(scene);
  } catch (const ajar::SceneError&) {
  } catch (const ajar::IoError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  import(input, input);
  import(kMesh, input);
  return 0;
}
