#include "measuring/reference_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "imageio/image_file.h"
#include "session/output/stats_json.h"

namespace ajar::bench {

namespace {

constexpr const char* kErrorLayer = "standard-error";

std::string as_file_name(std::string text) {
  std::replace_if(
      text.begin(), text.end(),
      [](unsigned char c) { return std::isalnum(c) == 0 && c != '-' && c != '.'; }, '_');
  return text;
}

}  // namespace

ReferenceStore::ReferenceStore(std::filesystem::path folder, ReferenceKey key)
    : folder_(std::move(folder)), key_(std::move(key)) {}

std::string ReferenceStore::path(std::uint64_t index, const char* extension) const {
  const std::string name =
      fmt::format("{}-{}x{}-d{}-{}-{}-{:016x}-seed{}{}", as_file_name(key_.scene),
                  key_.resolution.x, key_.resolution.y, key_.depth, as_file_name(key_.filter),
                  as_file_name(key_.variant), key_.scene_hash, index, extension);
  return (folder_ / name).string();
}

std::uint64_t ReferenceStore::count() const {
  std::uint64_t index = 0;
  while (std::filesystem::exists(path(index, ".json"))) ++index;
  return index;
}

std::vector<ReferencePart> ReferenceStore::load() const {
  std::vector<ReferencePart> parts;
  const std::size_t values = 3U * static_cast<std::size_t>(key_.resolution.x) *
                             static_cast<std::size_t>(key_.resolution.y);
  for (std::uint64_t index = 0; index < count(); ++index) {
    const std::string picture_path = path(index, ".exr");
    const Image image = read_image(picture_path);
    ReferencePart part{image.rgb(), image.rgb(kErrorLayer), 0, 0.0};
    if (part.picture.size() != values || part.standard_error.size() != values) {
      throw IoError(picture_path + ": is not a kept reference");
    }
    const std::string json_path = path(index, ".json");
    std::ifstream file(json_path);
    const nlohmann::json json = nlohmann::json::parse(file, nullptr, false);
    if (!json.is_object() || !json.contains("samples_per_pixel") || !json.contains("cpu_seconds")) {
      throw IoError(json_path + ": does not describe a kept reference");
    }
    part.samples = json["samples_per_pixel"];
    part.cpu_seconds = json["cpu_seconds"];
    parts.push_back(std::move(part));
  }
  return parts;
}

void ReferenceStore::add(const ReferencePart& part) const {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) throw IoError(folder_.string() + ": cannot make this folder: " + error.message());
  const std::uint64_t index = count();
  write_image(path(index, ".exr"),
              {.resolution = key_.resolution,
               .crop = {Vec2i(0, 0), key_.resolution - Vec2i(1, 1)},
               .layers = {{.name = "", .pixels = part.picture},
                          {.name = kErrorLayer, .pixels = part.standard_error}},
               .metadata = {}});
  // Last, so that a part that is there is whole.
  write_json({{"samples_per_pixel", part.samples},
              {"cpu_seconds", part.cpu_seconds},
              {"scene", key_.scene},
              {"variant", key_.variant}},
             path(index, ".json"));
}

}  // namespace ajar::bench
