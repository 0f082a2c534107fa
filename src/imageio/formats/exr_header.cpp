#include "imageio/formats/exr_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <optional>
#include <string_view>
#include <utility>

#include "core/printable_text.h"

namespace ajar {

namespace {

/// Reads little-endian parts of a file, and knows whether there were any left.
class Cursor {
 public:
  explicit Cursor(const std::string& path) : file_(path, std::ios::binary) {}
  bool is_good() const { return static_cast<bool>(file_); }
  std::uint64_t place() { return static_cast<std::uint64_t>(file_.tellg()); }
  std::int32_t number() {
    std::array<char, 4> bytes{};
    file_.read(bytes.data(), bytes.size());
    std::int32_t value = 0;
    std::memcpy(&value, bytes.data(), sizeof(value));
    return value;
  }
  /// Up to a zero byte; names are not longer than 255 bytes.
  std::string name() {
    constexpr std::size_t kLongest = 256;
    std::string text;
    for (char c = 0; text.size() < kLongest && file_.get(c) && c != '\0';) text += c;
    return text;
  }
  int byte() { return file_.get(); }
  void go_to(std::uint64_t place) { file_.seekg(static_cast<std::streamoff>(place)); }

 private:
  std::ifstream file_;
};

/// Bytes of an attribute of that type, if they are always so many. The library reads so many, and
/// goes on there, whatever size is written before.
std::optional<std::uint64_t> fixed_size(std::string_view type) {
  constexpr std::array<std::pair<std::string_view, int>, 23> kSizes = {
      {{"box2i", 16},      {"box2f", 16},   {"chromaticities", 32},
       {"compression", 1}, {"double", 8},   {"envmap", 1},
       {"float", 4},       {"int", 4},      {"keycode", 28},
       {"lineOrder", 1},   {"m33f", 36},    {"m44f", 64},
       {"m33d", 72},       {"m44d", 128},   {"rational", 8},
       {"tiledesc", 9},    {"timecode", 8}, {"v2i", 8},
       {"v2f", 8},         {"v2d", 16},     {"v3i", 12},
       {"v3f", 12},        {"v3d", 24}}};
  const auto found = std::find_if(kSizes.begin(), kSizes.end(),
                                  [&](const auto& entry) { return entry.first == type; });
  if (found == kSizes.end()) return std::nullopt;
  return static_cast<std::uint64_t>(found->second);
}

/// Claims of a part of the file.
struct Part {
  std::int64_t width = 0;
  std::int64_t rows = 0;
  int compression = 0;          ///< the format's number for it
  std::int64_t tile_width = 0;  ///< 0: rows, not tiles
  std::int64_t tile_height = 0;
  double pixel_bytes = 0.0;  ///< size over all channels

  void read_window(Cursor& cursor) {
    std::array<std::int64_t, 4> box{};
    for (std::int64_t& value : box) value = cursor.number();
    width = std::max<std::int64_t>(0, box[2] - box[0] + 1);
    rows = std::max<std::int64_t>(0, box[3] - box[1] + 1);
  }
  void read_tile_size(Cursor& cursor) {
    tile_width = std::max(cursor.number(), 1);
    tile_height = std::max(cursor.number(), 1);
  }
  /// Reads up to an empty name like the library, whatever size is written before.
  void read_channels(Cursor& cursor) {
    constexpr std::int32_t kHalf = 1;
    pixel_bytes = 0.0;
    while (cursor.is_good() && !cursor.name().empty()) {
      const double bytes = cursor.number() == kHalf ? 2.0 : 4.0;
      cursor.number();  // for the eye or not
      const double across = std::max(cursor.number(), 1);
      const double down = std::max(cursor.number(), 1);
      pixel_bytes += bytes / across / down;
    }
  }
};

/// Limits of one of the format's compressions.
struct Packing {
  double bytes_per_byte;  ///< largest expansion of a byte of the file
  std::int64_t rows;      ///< rows that are packed together
};
/// Bounds: runs stand for at most 127 bytes with two, deflate makes at most 1032 bytes of one, and
/// leaves out every fourth of a PXR24 number; PIZ packs 256 numbers of two bytes into ten bits;
/// B44A a flat block of 32 bytes into three; DWA deflates runs. What is unknown is as good as that.
Packing packing_of(int compression) {
  constexpr double kRuns = 64.0;
  constexpr double kDeflate = 1032.0;
  constexpr std::array<Packing, 10> kPackings = {{{1.0, 1},
                                                  {kRuns, 1},
                                                  {kDeflate, 1},
                                                  {kDeflate, 16},
                                                  {kDeflate, 32},
                                                  {kDeflate * 4.0 / 3.0, 16},
                                                  {32.0 / 3.0, 32},
                                                  {32.0 / 3.0, 32},
                                                  {kRuns * kDeflate, 32},
                                                  {kRuns * kDeflate, 256}}};
  const auto index = static_cast<std::size_t>(static_cast<unsigned char>(compression));
  return kPackings[std::min(index, kPackings.size() - 1)];
}

/// The library makes two things before it reads pixels: a table with eight bytes for each block of
/// rows or tile, which the file has, too, and room for one of them, however few pixels there are.
std::string part_complaint(const Part& part, std::uint64_t file_bytes) {
  // A file of few bytes may well have room for a block that it does not fill.
  constexpr double kUsualBlock = 1 << 26;
  const Packing packing = packing_of(part.compression);
  const auto file = static_cast<double>(file_bytes);
  const double most = file * packing.bytes_per_byte;
  const auto width = static_cast<double>(part.width);
  const auto rows = static_cast<double>(part.rows);
  const bool has_tiles = part.tile_width > 0;
  const double block_width =
      has_tiles ? static_cast<double>(part.tile_width) : std::max(width, 1.0);
  const auto block_rows = static_cast<double>(has_tiles ? part.tile_height : packing.rows);
  const double table = 8.0 * (width / block_width) * (rows / block_rows);
  const double block = block_width * block_rows * part.pixel_bytes;
  const double whole = width * rows * part.pixel_bytes;
  if (table <= file && whole <= most && block <= std::max(most, kUsualBlock)) return {};
  return fmt::format("it claims {}x{} pixels, but has {} bytes, which cannot hold them", part.width,
                     part.rows, file_bytes);
}

}  // namespace

std::string exr_header_complaint(const std::string& path, std::uint64_t file_bytes) {
  constexpr std::int32_t kMagic = 20000630;
  constexpr std::int32_t kSeveralParts = 0x1000;
  Cursor cursor(path);
  if (cursor.number() != kMagic) return {};
  const bool has_parts = (cursor.number() & kSeveralParts) != 0;
  bool header_is_empty = true;
  Part part;
  while (cursor.is_good()) {
    const std::string name = cursor.name();
    if (name.empty()) {
      // The end of a header, and of all of them if there is but one or this one is empty.
      if (std::string text = part_complaint(part, file_bytes); !text.empty()) return text;
      if (!has_parts || header_is_empty) return {};
      header_is_empty = true;
      part = {};
      continue;
    }
    header_is_empty = false;
    const std::string type = cursor.name();
    const std::int32_t size = cursor.number();
    const std::uint64_t place = cursor.place();
    if (!cursor.is_good()) return {};  // cut short, which the library says better
    if (size < 0 || static_cast<std::uint64_t>(size) > file_bytes - std::min(place, file_bytes)) {
      return fmt::format("its header claims {} bytes for \"{}\", but the file has {}",
                         static_cast<std::uint32_t>(size), printable_line(name), file_bytes);
    }
    const std::uint64_t end = place + static_cast<std::uint64_t>(size);
    std::uint64_t expected = fixed_size(type).value_or(end - place);
    if (name == "dataWindow") part.read_window(cursor);
    if (name == "compression") part.compression = cursor.byte();
    if (name == "tiles") part.read_tile_size(cursor);
    if (type == "chlist") {
      part.read_channels(cursor);
      expected = cursor.place() - place;
    }
    if (cursor.is_good() && expected != end - place) {
      return fmt::format("its header claims {} bytes for \"{}\", which has {}", end - place,
                         printable_line(name), expected);
    }
    cursor.go_to(end);
  }
  return {};
}

}  // namespace ajar
