#include "measuring/shared_reference.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "imageio/image_file.h"

namespace ajar::bench {

std::optional<std::vector<float>> shared_reference(const std::filesystem::path& shared,
                                                   const std::string& scene, Vec2i resolution,
                                                   int depth) {
  const std::filesystem::path folder = shared / "references";
  std::ifstream file(folder / "index.json");
  const nlohmann::json index = nlohmann::json::parse(file, nullptr, false);
  if (!index.is_array()) throw IoError((folder / "index.json").string() + ": is not a list");
  const std::string size = fmt::format("{}x{}", resolution.x, resolution.y);
  for (const nlohmann::json& entry : index) {
    if (entry.value("name", "") != scene || entry.value("resolution", "") != size ||
        entry.value("max_depth", 0) != depth) {
      continue;
    }
    return read_image((folder / (scene + ".exr")).string()).rgb();
  }
  return std::nullopt;
}

}  // namespace ajar::bench
