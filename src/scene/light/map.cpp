#include "scene/light/map.h"

#include <cmath>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <utility>

#include "color/srgb.h"
#include "imageio/image_input.h"
#include "scene/named_file.h"

namespace ajar {

namespace {
constexpr WarningKind kUnreadable{Effect::Light,
                                  "light maps (skies, spots) cannot be read: the light is magenta"};

constexpr WarningKind kOtherPrimaries{
    Effect::Light,
    "light maps are files with a red, green and blue of their own, which is not supported"};

constexpr WarningKind kChannels{Effect::Light,
                                "light maps are files of several layers, of which one is shown"};

/// Raises IoError with the reason if the file cannot be read.
Map read_map(const std::string& path, MapEdge edge, MapFilter filter,
             std::optional<float> decoding_exponent, bool* has_other_primaries,
             std::string* remark) {
  ImageInput input(path, true);
  const ImageHeader& header = input.header();
  constexpr int kMaxSide = 1 << 16;
  if (header.width > kMaxSide || header.height > kMaxSide) {
    throw IoError("it has more than 65536 pixels in a row or column");
  }
  const int channels = input.colors().count;
  *remark = input.colors().remark;
  *has_other_primaries = channels == 3 && header.has_other_primaries;
  const auto count = static_cast<std::size_t>(header.pixels());
  std::vector<float> values =
      input.read_from<float>(input.colors().first, channels, count * sizeof(Spectrum));
  if (header.is_integer) {
    for (float& v : values) {
      v = decoding_exponent ? std::pow(v, *decoding_exponent) : linear_from_srgb(v);
    }
  }
  std::vector<Spectrum> texels;
  texels.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const float* v = values.data() + i * static_cast<std::size_t>(channels);
    texels.push_back(channels == 3 ? Spectrum(v[0], v[1], v[2]) : Spectrum(v[0]));
  }
  return {header.width, header.height, std::move(texels), edge, filter};
}
}  // namespace

Map::Map(int width, int height, std::vector<Spectrum> texels, MapEdge edge, MapFilter filter)
    : width_(width), height_(height), edge_(edge), filter_(filter), texels_(std::move(texels)) {
  if (width <= 0 || height <= 0 ||
      texels_.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
    throw std::invalid_argument("Map: texels do not fit the size");
  }
  constexpr float kLargest = 1e30F;  // sums over a whole map stay finite
  for (Spectrum& texel : texels_) {
    texel = map_lanes(
        texel, [=](float v) { return std::isfinite(v) ? std::clamp(v, 0.F, kLargest) : 0.F; });
  }
}

Map load_map(const std::string& path, MapEdge edge, const SourceLocation& where, Warnings& warnings,
             MapFilter filter, const desc::EmbeddedFiles& embedded,
             std::optional<float> decoding_exponent) {
  std::string reason;
  try {
    bool has_other_primaries = false;
    std::string remark;
    Map map = read_map(NamedFile(path, embedded).path(), edge, filter, decoding_exponent,
                       &has_other_primaries, &remark);
    if (has_other_primaries) {
      warnings.add(kOtherPrimaries, where,
                   "light map \"" + path + "\" has red, green and blue of its own " +
                       "(\"chromaticities\"): they are taken for those of Rec. 709",
                   std::filesystem::path(path).filename().string());
    }
    if (!remark.empty()) {
      warnings.add(kChannels, where, "light map \"" + path + "\": " + remark,
                   std::filesystem::path(path).filename().string());
    }
    return map;
  } catch (const std::bad_alloc&) {
    reason = "not enough memory";
  } catch (const IoError& error) {
    reason = error.what();
  }
  warnings.add(kUnreadable, where,
               "cannot read light map \"" + path + "\": " + reason + "; the light is magenta",
               std::filesystem::path(path).filename().string());
  return {1, 1, {Spectrum(1.F, 0.F, 1.F)}, edge};
}

}  // namespace ajar
