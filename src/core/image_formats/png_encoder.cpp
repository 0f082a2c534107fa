#include <png.h>

#include "core/error.h"
#include "core/image_encoder.h"

namespace ajar {

namespace {

/// Errors as exceptions: see `PngReader`.
class PngWriter {
 public:
  explicit PngWriter(std::vector<unsigned char>& bytes)
      : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, on_error,
                                     [](png_structp, png_const_charp) {})),
        info_(png_ == nullptr ? nullptr : png_create_info_struct(png_)) {
    if (info_ == nullptr) throw IoError("the image does not fit into memory");
    png_set_write_fn(png_, &bytes, append, [](png_structp) {});
  }
  ~PngWriter() { png_destroy_write_struct(&png_, &info_); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  void write(const ImageLayout& layout, const RowSource<unsigned char>& row) {
    png_set_IHDR(png_, info_, static_cast<png_uint_32>(layout.width),
                 static_cast<png_uint_32>(layout.height), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png_, info_, PNG_sRGB_INTENT_ABSOLUTE);
    png_write_info(png_, info_);
    std::vector<unsigned char> values(3 * static_cast<std::size_t>(layout.width));
    for (int y = 0; y < layout.height; ++y) {
      row(y, values.data());
      png_write_row(png_, values.data());
    }
    png_write_end(png_, info_);
  }

 private:
  [[noreturn]] static void on_error(png_structp, png_const_charp what) { throw IoError(what); }
  static void append(png_structp png, png_bytep from, png_size_t count) {
    auto& bytes = *static_cast<std::vector<unsigned char>*>(png_get_io_ptr(png));
    bytes.insert(bytes.end(), from, from + count);
  }

  png_structp png_;
  png_infop info_;
};

}  // namespace

std::vector<unsigned char> encode_png(const ImageLayout& layout,
                                      const RowSource<unsigned char>& row) {
  std::vector<unsigned char> bytes;
  PngWriter(bytes).write(layout, row);
  return bytes;
}

}  // namespace ajar
