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
/// Of formats that are not read, for the message.
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

void WholeImageDecoder::describe_whole(int width, int height, int channels,
                                       bool has_unassociated_alpha, int stored_channels) {
  describe_pixels(width, height, channels, SampleType::UInt8);
  stored_channels_ = std::max(channels, stored_channels);
  multiplies_ = header().alpha_channel >= 0 && !has_unassociated_alpha;
}

void WholeImageDecoder::read_rows(int first, int rows, int first_channel, int channels,
                                  SampleType type, void* values) {
  const auto width = static_cast<std::size_t>(header().width);
  const auto stored = static_cast<std::size_t>(stored_channels_);
  if (!bytes_) {
    bytes_ = decode();
    if (multiplies_) {
      multiply_with_alpha(bytes_.get(), header().pixels(), stored,
                          static_cast<std::size_t>(header().alpha_channel));
    }
  }
  const ChannelPicker picker(stored_channels_, first_channel, channels, type);
  for (int y = first; y < first + rows; ++y) {
    picker.pick(bytes_.get() + static_cast<std::size_t>(y) * width * stored, width, values);
  }
}

}  // namespace image_formats

void ImageDecoder::describe_pixels(int width, int height, int channels, SampleType type) {
  header_.width = width;
  header_.height = height;
  header_.channels = channels;
  header_.resolution = {width, height};
  header_.type = type;
  header_.is_integer = type == SampleType::UInt8 || type == SampleType::UInt16;
  header_.names =
      channels < 3 ? std::vector<std::string>{"Y"} : std::vector<std::string>{"R", "G", "B"};
  if (channels % 2 == 0) {
    header_.alpha_channel = channels - 1;
    header_.names.emplace_back("A");
  }
}

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
