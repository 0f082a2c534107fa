#include "integrator/regions/user_regions.h"

#include <algorithm>
#include <array>

#include "core/error.h"
#include "integrator/regions/crop_weights.h"
#include "os/file_extension.h"
#include "os/regular_file.h"

namespace ajar {

namespace {

bool is_image(const std::string& path) {
  constexpr std::array kExtensions = {".exr", ".png", ".jpg", ".jpeg",
                                      ".pfm", ".hdr", ".tif", ".tiff"};
  const std::string extension = file_extension(path);
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

std::string read_text(const std::string& path) {
  try {
    const FileBytes file = read_file(path);
    std::string text(file.view());
    if (text.find('\0') == std::string::npos) return text;
  } catch (const IoError& error) {
    throw IoError(std::string("regions: ") + error.what());
  }
  throw IoError("regions: " + path +
                " is neither an image (.exr, .png, .jpg, .pfm, .hdr, .tif) nor a text file");
}

std::vector<float> read_painted(const std::string& path, const RenderSettings& settings) {
  std::vector<float> weights = read_crop_weights("regions", path, settings);
  for (float& weight : weights) {
    // White is 1 but for rounding. Written so that NaN fails.
    if (!(weight >= 0.F && weight <= 1.00001F)) {
      throw UsageError("regions: a pixel of " + path + " is not between 0 and 1");
    }
    weight = std::min(weight, 1.F);
  }
  return weights;
}

}  // namespace

ParameterSpec UserRegions::parameter() {
  return {.name = "regions",
          .type = ParameterType::Text,
          .default_value = "",
          .unit = "",
          .help =
              "regions that the user decides: a text file of rules (object or material, name, "
              "auto|omc|chain|weight), or an image of the chains' weight in each pixel",
          .choices = {}};
}

UserRegions UserRegions::read(const std::string& path, const Scene& scene,
                              const RenderSettings& settings) {
  if (path.empty()) return {};
  if (is_image(path)) return {.painted = read_painted(path, settings)};
  UserRegions result{.rules = parse_region_rules(read_text(path), path)};
  check_region_rules(result.rules, scene.object_names(), scene.material_names());
  return result;
}

std::vector<std::optional<float>> UserRegions::fixed_weights(const Regions& regions,
                                                             const Scene& scene,
                                                             float omc_weight) const {
  std::vector<std::optional<float>> fixed;
  for (const PixelIdentity& identity : regions.identities) {
    std::optional<float>& weight = fixed.emplace_back();
    // 0 is "nothing there": the environment.
    if (identity.object == 0 || identity.material == 0) continue;
    const RegionRule* rule = find_region_rule(rules, scene.object_names()[identity.object - 1],
                                              scene.material_names()[identity.material - 1]);
    if (rule != nullptr) weight = fixed_weight(*rule, omc_weight);
  }
  return fixed;
}

}  // namespace ajar
