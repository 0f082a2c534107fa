// Any text must either import or raise one of our errors. Files are served from memory; on the disk
// nothing is found.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "import/pbrt/pbrt_import.h"

namespace {

constexpr std::string_view kMesh =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  ajar::Warnings warnings;
  try {
    const ajar::desc::SceneDesc scene =
        ajar::import_pbrt_text(text, "fuzz.pbrt", "/nonexistent", warnings,
                               [&](const std::string& path) -> std::optional<std::string_view> {
                                 if (path == "/nonexistent/m.ply") return kMesh;
                                 if (path == "/nonexistent/self.pbrt") return text;
                                 if (path == "/nonexistent/a.spd") return "400 0.5\n700 1\n";
                                 if (path == "/nonexistent/self.spd") return text;
                                 return std::nullopt;
                               });
    ajar::desc::hash(scene);
  } catch (const ajar::SceneError&) {
  } catch (const ajar::IoError&) {
  }
  return 0;
}
