#include "imageio/formats/image_formats.h"
#include "imageio/formats/jpeg_library.h"

namespace ajar::image_formats {

namespace {

class JpegReader {
 public:
  explicit JpegReader(const std::string& path) : file_(open_file(path)) {
    codec_.err = &calls_;
    // Until this is whole, the destructor does not run.
    try {
      begin();
    } catch (...) {
      jpeg_destroy_decompress(&codec_);
      throw;
    }
  }
  ~JpegReader() { jpeg_destroy_decompress(&codec_); }
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;

  int width() const { return static_cast<int>(codec_.image_width); }
  int height() const { return static_cast<int>(codec_.image_height); }
  int channels() const { return codec_.out_color_space == JCS_GRAYSCALE ? 1 : 3; }
  /// Four of what is printed, which have become three.
  std::size_t stored_channels() const {
    return static_cast<std::size_t>(is_cmyk() ? 4 : channels());
  }
  bool has_several_scans() { return jpeg_has_multiple_scans(&codec_) != 0; }

  void read_row(unsigned char* to) {
    calls_.run([&] {
      if (!is_started_) jpeg_start_decompress(&codec_);
      is_started_ = true;
      jpeg_read_scanlines(&codec_, &to, 1);
    });
    if (is_cmyk()) make_rgb(to);
  }

 private:
  void begin() {
    calls_.run([&] {
      jpeg_create_decompress(&codec_);
      jpeg_stdio_src(&codec_, file_.get());
      jpeg_read_header(&codec_, TRUE);
    });
    // A few bytes each, and every one a walk over all pixels.
    progress_.progress_monitor = [](j_common_ptr codec) {
      constexpr int kMostScans = 500;
      if (reinterpret_cast<j_decompress_ptr>(codec)->input_scan_number > kMostScans) {
        JpegCalls::of(codec).fail("it has more than 500 scans");
      }
    };
    codec_.progress = &progress_;
  }
  bool is_cmyk() const { return codec_.out_color_space == JCS_CMYK; }
  /// Replaces inks by the light that they leave of white. Adobe's programs write them inverted.
  void make_rgb(unsigned char* row) const {
    constexpr int kWhole = 255;
    const int flip = codec_.saw_Adobe_marker != 0 ? 0 : kWhole;
    unsigned char* to = row;
    for (int x = 0; x < width(); ++x, row += 4) {
      const int rest = row[3] ^ flip;
      for (int c = 0; c < 3; ++c) {
        *to++ = static_cast<unsigned char>(((row[c] ^ flip) * rest + kWhole / 2) / kWhole);
      }
    }
  }

  File file_;
  JpegCalls calls_{"the image is damaged"};
  jpeg_progress_mgr progress_{};
  jpeg_decompress_struct codec_{};
  bool is_started_ = false;
};

class JpegDecoder final : public RowByRowDecoder {
 public:
  explicit JpegDecoder(const std::string& path)
      : path_(path), reader_(std::make_unique<JpegReader>(path)) {
    describe_pixels(reader_->width(), reader_->height(), reader_->channels(), SampleType::UInt8);
    row_.resize(static_cast<std::size_t>(header().width) * reader_->stored_channels());
  }

  double most_pixels_per_byte() const override { return packing::kUnknown; }
  std::uint64_t pixel_bytes() const override { return header().names.size(); }
  bool is_read_in_parts() const override { return true; }
  std::uint64_t working_bytes() const override {
    // All coefficients of a progressive file are kept.
    constexpr std::uint64_t kCoefficient = sizeof(JCOEF);
    constexpr std::uint64_t kRows = 64;
    return reader_->has_several_scans() ? header().pixels() * pixel_bytes() * kCoefficient
                                        : row_.size() * kRows;
  }

 private:
  void restart() override { reader_ = std::make_unique<JpegReader>(path_); }
  const void* next_row(int) override {
    reader_->read_row(row_.data());
    return row_.data();
  }

  std::string path_;
  std::unique_ptr<JpegReader> reader_;
  std::vector<unsigned char> row_;
};

}  // namespace

std::unique_ptr<ImageDecoder> open_jpeg(const std::string& path) {
  return std::make_unique<JpegDecoder>(path);
}

}  // namespace ajar::image_formats
