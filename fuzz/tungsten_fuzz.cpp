// Any text must either import or raise one of our errors, as a scene and as the files beside one:
// meshes, curves, instances. Files are served from memory; on the disk nothing is found.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "import/tungsten/tungsten_import.h"

namespace {

constexpr std::string_view kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
/// No vertices, no triangles.
constexpr std::string_view kWo3("\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0", 16);
/// A scene whose files are the input.
constexpr std::string_view kScene = R"({"camera": {}, "primitives": [
  {"type": "mesh", "file": "self.wo3", "smooth": true, "recompute_normals": true},
  {"type": "curves", "file": "self.fiber", "curve_taper": true},
  {"type": "curves", "file": "self.hair", "mode": "ribbon", "curve_thickness": 0.1},
  {"type": "instances", "masters": [{"type": "cube"}], "instances": "self.instances"}]})";

void import(std::string_view text, std::string_view input) {
  ajar::Warnings warnings;
  try {
    const ajar::desc::SceneDesc scene =
        ajar::import_tungsten_text(text, "fuzz.json", "/nonexistent", warnings,
                                   [&](const std::string& path) -> std::optional<std::string_view> {
                                     if (path == "/nonexistent/m.obj") return kObj;
                                     if (path == "/nonexistent/m.wo3") return kWo3;
                                     if (path.starts_with("/nonexistent/self.")) return input;
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
  import(kScene, input);
  return 0;
}
