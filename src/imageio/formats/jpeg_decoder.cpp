#include "imageio/formats/image_formats.h"
#include "imageio/formats/jpeg_library.h"
#include "imageio/image_packing.h"

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
  bool has_several_scans() { return jpeg_has_multiple_scans(&codec_) != 0; }

  void read_row(unsigned char* to) {
    calls_.run([&] {
      if (!is_started_) jpeg_start_decompress(&codec_);
      is_started_ = true;
      jpeg_read_scanlines(&codec_, &to, 1);
    });
  }

 private:
  void begin() {
    calls_.run([&] {
      jpeg_create_decompress(&codec_);
      jpeg_stdio_src(&codec_, file_.get());
      jpeg_read_header(&codec_, TRUE);
    });
    if (codec_.jpeg_color_space == JCS_CMYK || codec_.jpeg_color_space == JCS_YCCK) {
      throw ForeignImage("a JPEG in CMYK");
    }
    // A few bytes each, and every one a walk over all pixels.
    progress_.progress_monitor = [](j_common_ptr codec) {
      constexpr int kMostScans = 500;
      if (reinterpret_cast<j_decompress_ptr>(codec)->input_scan_number > kMostScans) {
        JpegCalls::of(codec).fail("it has more than 500 scans");
      }
    };
    codec_.progress = &progress_;
  }

  File file_;
  JpegCalls calls_{"the image is damaged"};
  jpeg_progress_mgr progress_{};
  jpeg_decompress_struct codec_{};
  bool is_started_ = false;
};

class JpegDecoder final : public ImageDecoder {
 public:
  explicit JpegDecoder(const std::string& path)
      : path_(path), reader_(std::make_unique<JpegReader>(path)) {
    ImageHeader& to = header_;
    to.width = reader_->width();
    to.height = reader_->height();
    to.channels = reader_->channels();
    to.resolution = {to.width, to.height};
    to.type = SampleType::UInt8;
    to.is_integer = true;
    to.names =
        to.channels == 1 ? std::vector<std::string>{"Y"} : std::vector<std::string>{"R", "G", "B"};
    row_.resize(static_cast<std::size_t>(to.width) * to.names.size());
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
  int block_height() const override { return 64; }

  void read_rows(int first, int rows, int first_channel, int channels, SampleType type,
                 void* values) override {
    if (first < next_) {
      reader_ = std::make_unique<JpegReader>(path_);
      next_ = 0;
    }
    const ChannelPicker picker(header().channels, first_channel, channels, type);
    for (; next_ < first + rows; ++next_) {
      reader_->read_row(row_.data());
      if (next_ >= first) {
        picker.pick(row_.data(), static_cast<std::size_t>(header().width), values);
      }
    }
  }

 private:
  std::string path_;
  std::unique_ptr<JpegReader> reader_;
  int next_ = 0;
  std::vector<unsigned char> row_;
};

}  // namespace

std::unique_ptr<ImageDecoder> open_jpeg(const std::string& path) {
  return std::make_unique<JpegDecoder>(path);
}

}  // namespace ajar::image_formats
