#include "imageio/png_chunks.h"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <string_view>

#include "core/printable_text.h"

namespace ajar {

std::string png_chunk_complaint(const std::string& path, std::uint64_t file_bytes) {
  constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
  constexpr std::uint64_t kAround = 12;  // length, name and checksum
  std::ifstream file(path, std::ios::binary);
  std::array<char, 8> bytes{};
  file.read(bytes.data(), bytes.size());
  if (!file || std::string_view(bytes.data(), bytes.size()) != kSignature) return {};
  for (std::uint64_t place = kSignature.size(); file.read(bytes.data(), bytes.size());) {
    std::uint64_t length = 0;
    for (int i = 0; i < 4; ++i) length = length << 8U | static_cast<unsigned char>(bytes[i]);
    const std::string_view name(bytes.data() + 4, 4);
    if (name == "IEND") return {};
    if (length > file_bytes - place) {
      return fmt::format("its chunk \"{}\" claims {} bytes, but the file has {}",
                         printable_line(name), length, file_bytes);
    }
    place += kAround + length;
    if (place >= file_bytes) return {};  // cut short, which the library says better
    file.seekg(static_cast<std::streamoff>(place));
  }
  return {};
}

}  // namespace ajar
