#include "core/exr_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>

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
  void skip(std::uint64_t bytes) { file_.seekg(static_cast<std::streamoff>(bytes), std::ios::cur); }

 private:
  std::ifstream file_;
};

/// The box of pixels that the file holds. Rows come in blocks of at most 256, and each block has
/// eight bytes in a table; the library makes the table before it reads it.
std::string window_complaint(Cursor& cursor, std::uint64_t file_bytes) {
  std::array<std::int64_t, 4> box{};
  for (std::int64_t& value : box) value = cursor.number();
  constexpr std::int64_t kMostRowsPerBlock = 256;
  const std::int64_t rows = box[3] - box[1] + 1;
  const auto table = static_cast<std::uint64_t>(std::max<std::int64_t>(0, rows)) * 8U /
                     static_cast<std::uint64_t>(kMostRowsPerBlock);
  if (!cursor.is_good() || table <= file_bytes) return {};
  return fmt::format("it claims {} rows of pixels, but has {} bytes, which cannot hold them", rows,
                     file_bytes);
}

}  // namespace

std::string exr_header_complaint(const std::string& path, std::uint64_t file_bytes) {
  constexpr std::int32_t kMagic = 20000630;
  constexpr std::int32_t kSeveralParts = 0x1000;
  Cursor cursor(path);
  if (cursor.number() != kMagic) return {};
  const bool has_parts = (cursor.number() & kSeveralParts) != 0;
  bool header_is_empty = true;
  while (cursor.is_good()) {
    const std::string name = cursor.name();
    if (name.empty()) {
      // The end of a header, and of all of them if there is but one or this one is empty.
      if (!has_parts || header_is_empty) return {};
      header_is_empty = true;
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
    if (name == "dataWindow" && size == 16) {
      if (std::string text = window_complaint(cursor, file_bytes); !text.empty()) return text;
    } else {
      cursor.skip(static_cast<std::uint64_t>(size));
    }
  }
  return {};
}

}  // namespace ajar
