// Any text must either import or raise one of our errors. Files are served from memory; on the disk
// nothing is found.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "import/tungsten/tungsten_import.h"

namespace {

constexpr std::string_view kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
/// No vertices, no triangles.
constexpr std::string_view kWo3("\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0", 16);

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  ajar::Warnings warnings;
  try {
    const ajar::desc::SceneDesc scene =
        ajar::import_tungsten_text(text, "fuzz.json", "/nonexistent", warnings,
                                   [&](const std::string& path) -> std::optional<std::string_view> {
                                     if (path == "/nonexistent/m.obj") return kObj;
                                     if (path == "/nonexistent/m.wo3") return kWo3;
                                     if (path == "/nonexistent/self.wo3") return text;
                                     return std::nullopt;
                                   });
    ajar::desc::hash(scene);
  } catch (const ajar::SceneError&) {
  } catch (const ajar::IoError&) {
  }
  return 0;
}
