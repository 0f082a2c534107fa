// Any bytes must either import or raise one of our errors. Files are served from memory; on the
// disk nothing is found.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/error.h"
#include "import/gltf/gltf_import.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  ajar::Warnings warnings;
  try {
    const ajar::desc::SceneDesc scene =
        ajar::import_gltf_bytes(bytes, "fuzz.gltf", "/nonexistent", warnings,
                                [&](const std::string& path) -> std::optional<std::string_view> {
                                  if (path == "/nonexistent/self.bin") return bytes;
                                  return std::nullopt;
                                });
    ajar::desc::hash(scene);
  } catch (const ajar::SceneError&) {
  } catch (const ajar::IoError&) {
  }
  return 0;
}
