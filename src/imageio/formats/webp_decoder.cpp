#include <webp/decode.h>

#include <filesystem>

#include "imageio/formats/image_formats.h"
#include "os/regular_file.h"

namespace ajar::image_formats {

namespace {

/// Fixed odds of a block's modes take a bit and a half for 16 × 16 pixels (RFC 6386, section 11.2).
constexpr double kVp8 = 2048.0;
/// A colour alone takes no bits; but its own encoder makes at most 26 000 pixels of a byte.
constexpr double kVp8Lossless = 65536.0;

class WebpDecoder final : public WholeImageDecoder {
 public:
  WebpDecoder(const std::string& path, bool has_unassociated_alpha)
      : path_(path), file_bytes_(std::filesystem::file_size(path)) {
    const File file = open_file(path);
    // Enough for any header but for what stands between: colour profiles.
    std::vector<unsigned char> bytes;
    VP8StatusCode status = VP8_STATUS_NOT_ENOUGH_DATA;
    for (std::size_t size = 4096; status == VP8_STATUS_NOT_ENOUGH_DATA; size *= 2) {
      const std::size_t before = bytes.size();
      bytes.resize(size);
      bytes.resize(before + std::fread(bytes.data() + before, 1, size - before, file.get()));
      if (bytes.size() == before) break;
      status = WebPGetFeatures(bytes.data(), bytes.size(), &features_);
    }
    if (status != VP8_STATUS_OK) throw IoError("the image is damaged (its header is no WebP's)");
    if (features_.has_animation != 0) throw IoError("it is an animated WebP, which is not read");
    describe_pixels(features_.width, features_.height, features_.has_alpha != 0 ? 4 : 3,
                    SampleType::UInt8);
    multiplies_ = header().alpha_channel >= 0 && !has_unassociated_alpha;
  }

  double most_pixels_per_byte() const override {
    constexpr int kLossy = 1;
    return features_.format == kLossy ? kVp8 : kVp8Lossless;
  }
  /// The file, and its pixels before they are colours.
  std::uint64_t working_bytes() const override { return file_bytes_ + header().pixels() * 4; }

 private:
  LibraryBytes decode() override {
    const FileBytes file = read_file(path_);
    const auto* bytes = reinterpret_cast<const unsigned char*>(file.view().data());
    const auto decoder = header().channels == 4 ? WebPDecodeRGBA : WebPDecodeRGB;
    int width = 0;
    int height = 0;
    LibraryBytes pixels(decoder(bytes, file.view().size(), &width, &height), WebPFree);
    if (!pixels || width != header().width || height != header().height)
      throw IoError("the image is damaged (its WebP data cannot be decoded)");
    return pixels;
  }

  std::string path_;
  std::uint64_t file_bytes_;
  WebPBitstreamFeatures features_{};
};

}  // namespace

std::unique_ptr<ImageDecoder> open_webp(const std::string& path, bool has_unassociated_alpha) {
  return std::make_unique<WebpDecoder>(path, has_unassociated_alpha);
}

}  // namespace ajar::image_formats
