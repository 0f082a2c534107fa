#include <array>

#include "core/image_encoder.h"
#include "core/image_formats/jpeg_library.h"

namespace ajar {

namespace {

/// Takes what is encoded, piece by piece.
class MemoryTarget : public jpeg_destination_mgr {
 public:
  explicit MemoryTarget(std::vector<unsigned char>& bytes) : jpeg_destination_mgr{}, bytes_(bytes) {
    init_destination = [](j_compress_ptr codec) { of(codec).begin(); };
    empty_output_buffer = [](j_compress_ptr codec) -> boolean {
      of(codec).take(kPiece);
      of(codec).begin();
      return TRUE;
    };
    term_destination = [](j_compress_ptr codec) {
      of(codec).take(kPiece - of(codec).free_in_buffer);
    };
  }

 private:
  static constexpr std::size_t kPiece = std::size_t{1} << 16U;
  static MemoryTarget& of(j_compress_ptr codec) { return static_cast<MemoryTarget&>(*codec->dest); }
  void begin() {
    next_output_byte = piece_.data();
    free_in_buffer = kPiece;
  }
  void take(std::size_t count) {
    bytes_.insert(bytes_.end(), piece_.begin(),
                  piece_.begin() + static_cast<std::ptrdiff_t>(count));
  }

  std::vector<unsigned char>& bytes_;
  std::array<unsigned char, kPiece> piece_{};
};

/// Gone with all that it holds, however it is left.
struct Compressor : jpeg_compress_struct {
  explicit Compressor(jpeg_error_mgr& errors) : jpeg_compress_struct{} {
    err = image_formats::raise_errors(errors);
    jpeg_create_compress(this);
  }
  ~Compressor() { jpeg_destroy_compress(this); }
  Compressor(const Compressor&) = delete;
  Compressor& operator=(const Compressor&) = delete;
};

}  // namespace

std::vector<unsigned char> encode_jpeg(const ImageLayout& layout,
                                       const RowSource<unsigned char>& row) {
  std::vector<unsigned char> bytes;
  jpeg_error_mgr errors{};
  MemoryTarget target(bytes);
  Compressor codec(errors);
  codec.dest = &target;
  codec.image_width = static_cast<JDIMENSION>(layout.width);
  codec.image_height = static_cast<JDIMENSION>(layout.height);
  codec.input_components = 3;
  codec.in_color_space = JCS_RGB;
  jpeg_set_defaults(&codec);
  constexpr int kQuality = 95;
  jpeg_set_quality(&codec, kQuality, TRUE);
  jpeg_start_compress(&codec, TRUE);
  std::vector<unsigned char> values(3 * static_cast<std::size_t>(layout.width));
  for (int y = 0; y < layout.height; ++y) {
    row(y, values.data());
    unsigned char* line = values.data();
    jpeg_write_scanlines(&codec, &line, 1);
  }
  jpeg_finish_compress(&codec);
  return bytes;
}

}  // namespace ajar
