#include <png.h>

#include <string>

#include "core/error.h"
#include "imageio/formats/image_formats.h"
#include "imageio/formats/library_calls.h"

namespace ajar::image_formats {

namespace {

/// The library's own structures of a file that is read.
class PngReader {
 public:
  explicit PngReader(const std::string& path) : file_(open_file(path)) {
    // Until this is whole, the destructor does not run.
    try {
      begin();
    } catch (...) {
      destroy();
      throw;
    }
  }
  ~PngReader() { destroy(); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  int width() const { return static_cast<int>(png_get_image_width(png_, info_)); }
  int height() const { return static_cast<int>(png_get_image_height(png_, info_)); }
  int channels() const { return png_get_channels(png_, info_); }
  bool has_16_bits() const { return png_get_bit_depth(png_, info_) == 16; }
  bool is_interlaced() const { return png_get_interlace_type(png_, info_) != PNG_INTERLACE_NONE; }
  std::size_t row_bytes() const { return png_get_rowbytes(png_, info_); }
  void read_row(unsigned char* to) {
    calls_.run([&] { png_read_row(png_, to, nullptr); });
  }
  void read_all(unsigned char** rows) {
    calls_.run([&] { png_read_image(png_, rows); });
  }

 private:
  void begin() {
    calls_.run([&] {
      png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning);
      if (png_ != nullptr) info_ = png_create_info_struct(png_);
    });
    if (info_ == nullptr) throw IoError("the image does not fit into memory");
    calls_.run([&] {
      png_init_io(png_, file_.get());
      // All but the pixels is left out: the library would make room for what a chunk claims to
      // hold.
      png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
      png_read_info(png_, info_);
      png_set_expand(png_);
      png_set_swap(png_);  // x86-64 is little-endian
      png_set_interlace_handling(png_);
      png_read_update_info(png_, info_);
    });
  }
  void destroy() { png_destroy_read_struct(&png_, &info_, nullptr); }
  [[noreturn]] static void on_error(png_structp png, png_const_charp what) {
    static_cast<PngReader*>(png_get_error_ptr(png))->calls_.fail(what);
  }
  static void on_warning(png_structp, png_const_charp) {}

  File file_;
  LibraryCalls calls_{"the image is damaged"};
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

class PngDecoder final : public RowByRowDecoder {
 public:
  PngDecoder(const std::string& path, bool has_unassociated_alpha)
      : path_(path), reader_(std::make_unique<PngReader>(path)) {
    describe_pixels(reader_->width(), reader_->height(), reader_->channels(),
                    reader_->has_16_bits() ? SampleType::UInt16 : SampleType::UInt8);
    multiplies_ = header().alpha_channel >= 0 && !has_unassociated_alpha;
  }

  double most_pixels_per_byte() const override { return packing::kDeflate; }
  std::uint64_t pixel_bytes() const override {
    return header().names.size() * size_of(header().type);
  }
  bool is_read_in_parts() const override { return !reader_->is_interlaced(); }
  std::uint64_t working_bytes() const override { return 2 * reader_->row_bytes(); }

 private:
  void restart() override {
    reader_ = std::make_unique<PngReader>(path_);
    whole_.clear();
  }
  const void* next_row(int y) override {
    const std::size_t bytes = reader_->row_bytes();
    if (!reader_->is_interlaced()) {
      whole_.resize(bytes);
      reader_->read_row(whole_.data());
      return whole_.data();
    }
    const auto rows = static_cast<std::size_t>(header().height);
    if (whole_.empty()) {
      whole_.resize(bytes * rows);
      std::vector<unsigned char*> starts(rows);
      for (std::size_t i = 0; i < rows; ++i) starts[i] = whole_.data() + i * bytes;
      reader_->read_all(starts.data());
    }
    return whole_.data() + static_cast<std::size_t>(y) * bytes;
  }

  std::string path_;
  std::unique_ptr<PngReader> reader_;
  std::vector<unsigned char> whole_;  ///< the row that was read last, or all of an interlaced image
};

}  // namespace

std::unique_ptr<ImageDecoder> open_png(const std::string& path, bool has_unassociated_alpha) {
  return std::make_unique<PngDecoder>(path, has_unassociated_alpha);
}

}  // namespace ajar::image_formats
