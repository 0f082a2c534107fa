#include <png.h>

#include "core/error.h"
#include "imageio/formats/appended.h"
#include "imageio/formats/library_calls.h"
#include "imageio/image_encoder.h"

namespace ajar {

namespace {

class PngWriter {
 public:
  explicit PngWriter(std::vector<unsigned char>& bytes) : bytes_(bytes) {
    calls_.run([&] {
      png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, this, on_error,
                                     [](png_structp, png_const_charp) {});
      if (png_ != nullptr) info_ = png_create_info_struct(png_);
      if (info_ != nullptr) png_set_write_fn(png_, this, append, [](png_structp) {});
    });
    if (info_ != nullptr) return;
    png_destroy_write_struct(&png_, nullptr);
    throw IoError("the image does not fit into memory");
  }
  ~PngWriter() { png_destroy_write_struct(&png_, &info_); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  void write(const ImageLayout& layout, const RowSource<unsigned char>& row) {
    calls_.run([&] {
      png_set_IHDR(png_, info_, static_cast<png_uint_32>(layout.width),
                   static_cast<png_uint_32>(layout.height), 8,
                   layout.names.size() == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB,
                   PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
      png_set_sRGB(png_, info_, PNG_sRGB_INTENT_ABSOLUTE);
      png_write_info(png_, info_);
    });
    std::vector<unsigned char> values(layout.names.size() * static_cast<std::size_t>(layout.width));
    for (int y = 0; y < layout.height; ++y) {
      row(y, values.data());
      const unsigned char* line = values.data();
      calls_.run([&] { png_write_row(png_, line); });
    }
    calls_.run([&] { png_write_end(png_, info_); });
  }

 private:
  [[noreturn]] static void on_error(png_structp png, png_const_charp what) {
    static_cast<PngWriter*>(png_get_error_ptr(png))->calls_.fail(what);
  }
  static void append(png_structp png, png_bytep from, png_size_t count) {
    const PngWriter& writer = *static_cast<PngWriter*>(png_get_io_ptr(png));
    if (!image_formats::appended(writer.bytes_, from, count)) {
      png_error(png, "it does not fit into memory");
    }
  }

  std::vector<unsigned char>& bytes_;
  image_formats::LibraryCalls calls_{"the image cannot be written"};
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

}  // namespace

std::vector<unsigned char> encode_png(const ImageLayout& layout,
                                      const RowSource<unsigned char>& row) {
  std::vector<unsigned char> bytes;
  PngWriter(bytes).write(layout, row);
  return bytes;
}

}  // namespace ajar
