#include <cstdlib>
#include <cstring>

#include "imageio/formats/image_formats.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
#define STBI_NO_LINEAR
#define STBI_NO_STDIO
#define STBI_FAILURE_USERMSG
#include <stb/stb_image.h>

namespace ajar::image_formats {

namespace {

/// A file as stb reads it, which does not tell itself where files end: it would go on with zeros,
/// or with what was in memory.
class StbSource {
 public:
  explicit StbSource(const std::string& path) : file_(open_file(path)) {}
  static const stbi_io_callbacks* calls() {
    static constexpr stbi_io_callbacks kCalls = {read, skip, is_at_end};
    return &kCalls;
  }
  bool was_too_short() const { return was_too_short_; }

 private:
  static StbSource& of(void* source) { return *static_cast<StbSource*>(source); }
  static int read(void* source, char* to, int size) {
    // Its own buffer, which it fills when the next byte is not there.
    constexpr int kBuffer = sizeof(stbi__context::buffer_start);
    const auto count =
        static_cast<int>(std::fread(to, 1, static_cast<std::size_t>(size), of(source).file_.get()));
    std::memset(to + count, 0, static_cast<std::size_t>(size - count));
    if (count == 0 || (count < size && size != kBuffer)) of(source).was_too_short_ = true;
    return count;
  }
  static void skip(void* source, int count) { std::fseek(of(source).file_.get(), count, SEEK_CUR); }
  static int is_at_end(void* source) { return std::feof(of(source).file_.get()); }

  File file_;
  bool was_too_short_ = false;
};

class StbDecoder final : public WholeImageDecoder {
 public:
  StbDecoder(const std::string& path, int width, int height, int channels,
             bool has_unassociated_alpha)
      : path_(path) {
    describe_pixels(width, height, channels, SampleType::UInt8);
    multiplies_ = header().alpha_channel >= 0 && !has_unassociated_alpha;
  }

  double most_pixels_per_byte() const override { return packing::kRuns; }
  /// The rows of the file, before they are put in order and converted.
  std::uint64_t working_bytes() const override { return header().pixels() * pixel_bytes(); }

 private:
  LibraryBytes decode() override {
    StbSource source(path_);
    int width = 0;
    int height = 0;
    int channels = 0;
    LibraryBytes bytes(stbi_load_from_callbacks(StbSource::calls(), &source, &width, &height,
                                                &channels, header().channels),
                       std::free);
    if (source.was_too_short()) {
      throw IoError("the image is damaged (the file ends before the picture does)");
    }
    if (!bytes || width != header().width || height != header().height) {
      throw IoError(std::string("the image cannot be read (") + stbi_failure_reason() + ")");
    }
    return bytes;
  }

  std::string path_;
};

}  // namespace

std::unique_ptr<ImageDecoder> open_stb(const std::string& path, bool has_unassociated_alpha) {
  StbSource source(path);
  int width = 0;
  int height = 0;
  int channels = 0;
  if (stbi_info_from_callbacks(StbSource::calls(), &source, &width, &height, &channels) == 0) {
    return nullptr;
  }
  return std::make_unique<StbDecoder>(path, width, height, channels, has_unassociated_alpha);
}

}  // namespace ajar::image_formats
