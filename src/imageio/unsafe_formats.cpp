#include "imageio/unsafe_formats.h"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <string_view>

namespace ajar {

namespace {

struct Refused {
  std::string_view signature;
  std::string_view name;
};
using namespace std::string_view_literals;
constexpr std::array<Refused, 5> kRefused = {{{"SDPX"sv, "a DPX"sv},
                                              {"XPDS"sv, "a DPX"sv},
                                              {"FOR4"sv, "an IFF"sv},
                                              {"\0\0\1\0"sv, "an icon"sv},
                                              {"\x53\x80\xf6\x34"sv, "a picture of Softimage"sv}}};

/// A big-endian number of `count` bytes.
std::uint64_t big_endian_at(std::string_view bytes, std::size_t place, std::size_t count) {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < count; ++i) {
    number = number << 8U | static_cast<unsigned char>(bytes[place + i]);
  }
  return number;
}

/// SGI: the header, and where the rows are. Source: Haeberli, "The SGI Image File Format", 1.00.
std::string sgi_complaint(std::string_view header, std::ifstream& file, std::uint64_t file_bytes) {
  constexpr std::size_t kHeader = 512;
  const std::uint64_t storage = big_endian_at(header, 2, 1);
  const std::uint64_t value_bytes = big_endian_at(header, 3, 1);
  const std::uint64_t dimensions = big_endian_at(header, 4, 2);
  const std::uint64_t rows = dimensions > 1 ? big_endian_at(header, 8, 2) : 1;
  const std::uint64_t channels = dimensions > 2 ? big_endian_at(header, 10, 2) : 1;
  if (storage > 1 || value_bytes < 1 || value_bytes > 2 || dimensions < 1 || dimensions > 3) {
    return "its header is damaged";
  }
  const std::uint64_t count = rows * channels;
  const std::uint64_t width = big_endian_at(header, 6, 2);
  if (storage == 0) {
    if (kHeader + width * count * value_bytes <= file_bytes) return {};
    return fmt::format("it claims {}x{} pixels, but has {} bytes, which cannot hold them", width,
                       rows, file_bytes);
  }
  if (kHeader + 8 * count > file_bytes) return "it is cut short";
  std::string table(8 * count, '\0');
  file.seekg(kHeader);
  file.read(table.data(), static_cast<std::streamsize>(table.size()));
  if (!file) return "it is cut short";
  for (std::size_t row = 0; row < count; ++row) {
    const std::uint64_t begin = big_endian_at(table, 4 * row, 4);
    const std::uint64_t length = big_endian_at(table, 4 * (count + row), 4);
    if (begin + length > file_bytes) return "it is cut short";
  }
  return {};
}

}  // namespace

std::string unsafe_format_complaint(const std::string& path, std::uint64_t file_bytes) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, 12> start{};
  file.read(start.data(), start.size());
  const std::string_view bytes(start.data(), start.size());
  for (const Refused& refused : kRefused) {
    if (!bytes.starts_with(refused.signature)) continue;
    return "it is " + std::string(refused.name) +
           ", which is not read: damaged ones would end the program; save it as PNG or EXR";
  }
  if (file && bytes.starts_with("\x01\xda")) return sgi_complaint(bytes, file, file_bytes);
  return {};
}

}  // namespace ajar
