#include "import/mitsuba/volume_file.h"

#include <bit>
#include <cstdint>
#include <cstring>

namespace ajar::mitsuba {
namespace {

static_assert(std::endian::native == std::endian::little, "the format is read as it is in memory");

constexpr std::string_view kBegin = "VOL\x03";
constexpr std::size_t kHeader = 48;
constexpr std::int32_t kFloats = 1;
constexpr std::int32_t kBytes = 3;
constexpr std::int32_t kMostChannels = 6;

template <typename T>
T number_at(std::string_view bytes, std::size_t place) {
  T value;
  std::memcpy(&value, bytes.data() + place, sizeof(T));
  return value;
}

}  // namespace

VolumeFile read_volume_file(std::string_view bytes, const SourceLocation& where) {
  if (bytes.size() < kHeader || !bytes.starts_with("VOL")) {
    throw SceneError(where, "this is no grid of a volume");
  }
  if (!bytes.starts_with(kBegin)) throw SceneError(where, "only version 3 of the format is known");
  const auto encoding = number_at<std::int32_t>(bytes, 4);
  if (encoding != kFloats && encoding != kBytes) {
    throw SceneError(where, "encoding " + std::to_string(encoding) +
                                " is not supported: only floats of 32 bits (1) and bytes (3) are");
  }
  VolumeFile file;
  file.channels = number_at<std::int32_t>(bytes, 20);
  if (file.channels < 1 || file.channels > kMostChannels) {
    throw SceneError(where, "there cannot be " + std::to_string(file.channels) + " channels");
  }
  double count = file.channels;
  for (int axis = 0; axis < 3; ++axis) {
    const auto index = static_cast<std::size_t>(axis);
    file.resolution[axis] = number_at<std::int32_t>(bytes, 8 + 4 * index);
    file.low[axis] = number_at<float>(bytes, 24 + 4 * index);
    file.high[axis] = number_at<float>(bytes, 36 + 4 * index);
    if (file.resolution[axis] < 1) throw SceneError(where, "the grid has no cells");
    // In doubles: the product may overflow integers.
    count *= file.resolution[axis];
  }
  bytes.remove_prefix(kHeader);
  const std::size_t size = encoding == kFloats ? sizeof(float) : 1;
  if (count > static_cast<double>(bytes.size() / size)) {
    throw SceneError(where, "the file is damaged or ends early");
  }
  file.values.resize(static_cast<std::size_t>(count));
  if (encoding == kFloats) {
    std::memcpy(file.values.data(), bytes.data(), file.values.size() * sizeof(float));
  } else {
    for (std::size_t i = 0; i < file.values.size(); ++i) {
      file.values[i] = static_cast<float>(static_cast<unsigned char>(bytes[i])) / 255.F;
    }
  }
  return file;
}

}  // namespace ajar::mitsuba
