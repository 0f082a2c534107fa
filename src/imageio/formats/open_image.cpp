#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>

#include "imageio/formats/image_formats.h"

namespace ajar {

namespace image_formats {

namespace {

constexpr const char* kRead = "EXR, PNG, JPEG, HDR, TIFF, WebP, TGA, BMP, PPM, PGM and PFM are";

struct Signature {
  std::string_view bytes;
  std::string_view format;
};
using namespace std::string_view_literals;
/// Signatures of formats that are not read, for the message.
constexpr std::array<Signature, 10> kOthers = {{{"GIF"sv, "a GIF"sv},
                                                {"8BPS"sv, "a PSD"sv},
                                                {"DDS "sv, "a DDS"sv},
                                                {"\xabKTX"sv, "a KTX"sv},
                                                {"\0\0\0\x0cjP"sv, "a JPEG 2000"sv},
                                                {"SDPX"sv, "a DPX"sv},
                                                {"XPDS"sv, "a DPX"sv},
                                                {"FOR4"sv, "an IFF"sv},
                                                {"\x01\xda"sv, "an SGI"sv},
                                                {"\0\0\1\0"sv, "an icon"sv}}};

std::string beginning_of(const std::string& path) {
  const File file = open_file(path);
  std::string bytes(16, '\0');
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file.get()));
  return bytes;
}

bool is_tiff(std::string_view bytes) {
  return bytes.starts_with("II*\0"sv) || bytes.starts_with("MM\0*"sv) ||
         bytes.starts_with("II+\0"sv) || bytes.starts_with("MM\0+"sv);
}

}  // namespace

File open_file(const std::string& path) {
  File file(std::fopen(path.c_str(), "rbe"));
  if (!file) throw IoError(std::generic_category().message(errno));
  return file;
}

void RowByRowDecoder::read_rows(int first, int rows, int first_channel, int channels,
                                SampleType type, void* values) {
  if (first < next_) {
    restart();
    next_ = 0;
  }
  for (; next_ < first + rows; ++next_) {
    const void* row = next_row(next_);
    if (next_ >= first) pick(row, first_channel, channels, type, values);
  }
}

void WholeImageDecoder::read_rows(int first, int rows, int first_channel, int channels,
                                  SampleType type, void* values) {
  if (!bytes_) bytes_ = decode();
  const auto row =
      static_cast<std::size_t>(header().width) * static_cast<std::size_t>(pixel_bytes());
  for (int y = first; y < first + rows; ++y) {
    pick(bytes_.get() + static_cast<std::size_t>(y) * row, first_channel, channels, type, values);
  }
}

}  // namespace image_formats

std::unique_ptr<ImageDecoder> open_image(const std::string& path, bool has_unassociated_alpha) {
  using namespace image_formats;
  const std::string bytes = beginning_of(path);
  if (bytes.starts_with("\x76\x2f\x31\x01")) return open_exr(path);
  if (bytes.starts_with("\x89PNG")) return open_png(path, has_unassociated_alpha);
  if (bytes.starts_with("\xff\xd8")) return open_jpeg(path);
  if (bytes.starts_with("#?")) return open_hdr(path);
  for (const char* map : {"PF", "Pf", "P5", "P6"}) {
    if (bytes.starts_with(map)) return open_pnm(path);
  }
  if (is_tiff(bytes)) return open_tiff(path, has_unassociated_alpha);
  if (bytes.starts_with("RIFF") && bytes.find("WEBP") == 8) {
    return open_webp(path, has_unassociated_alpha);
  }
  for (const Signature& other : kOthers) {
    if (!bytes.starts_with(other.bytes)) continue;
    throw IoError("it is " + std::string(other.format) + ", which is not read; " + kRead);
  }
  if (auto decoder = open_stb(path, has_unassociated_alpha)) return decoder;
  throw IoError(std::string(bytes.starts_with("BM")
                                ? "it is a BMP in runs, which is not read, or a damaged one; "
                                : "it is no image of a format that is read; ") +
                kRead);
}

}  // namespace ajar
