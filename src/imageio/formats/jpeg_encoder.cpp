#include <array>

#include "imageio/formats/appended.h"
#include "imageio/formats/jpeg_library.h"
#include "imageio/image_encoder.h"

namespace ajar {

using image_formats::appended;
using image_formats::JpegCalls;

namespace {

/// Takes what is encoded, piece by piece.
class MemoryTarget : public jpeg_destination_mgr {
 public:
  explicit MemoryTarget(std::vector<unsigned char>& bytes) : jpeg_destination_mgr{}, bytes_(bytes) {
    init_destination = [](j_compress_ptr codec) { of(codec).begin(); };
    empty_output_buffer = [](j_compress_ptr codec) -> boolean {
      take(codec, kPiece);
      of(codec).begin();
      return TRUE;
    };
    term_destination = [](j_compress_ptr codec) { take(codec, kPiece - of(codec).free_in_buffer); };
  }

 private:
  static constexpr std::size_t kPiece = std::size_t{1} << 16U;
  static MemoryTarget& of(j_compress_ptr codec) { return static_cast<MemoryTarget&>(*codec->dest); }
  void begin() {
    next_output_byte = piece_.data();
    free_in_buffer = kPiece;
  }
  static void take(j_compress_ptr codec, std::size_t count) {
    MemoryTarget& target = of(codec);
    if (!appended(target.bytes_, target.piece_.data(), count)) {
      JpegCalls::of(codec).fail("it does not fit into memory");
    }
  }

  std::vector<unsigned char>& bytes_;
  std::array<unsigned char, kPiece> piece_{};
};

/// Gone with all that it holds, however it is left.
struct Compressor : jpeg_compress_struct {
  explicit Compressor(JpegCalls& calls) : jpeg_compress_struct{} { err = &calls; }
  ~Compressor() { jpeg_destroy_compress(this); }
  Compressor(const Compressor&) = delete;
  Compressor& operator=(const Compressor&) = delete;
};

}  // namespace

std::vector<unsigned char> encode_jpeg(const ImageLayout& layout,
                                       const RowSource<unsigned char>& row) {
  std::vector<unsigned char> bytes;
  JpegCalls calls("the image cannot be written");
  MemoryTarget target(bytes);
  Compressor codec(calls);
  calls.run([&] {
    jpeg_create_compress(&codec);
    codec.dest = &target;
    codec.image_width = static_cast<JDIMENSION>(layout.width);
    codec.image_height = static_cast<JDIMENSION>(layout.height);
    codec.input_components = 3;
    codec.in_color_space = JCS_RGB;
    jpeg_set_defaults(&codec);
    constexpr int kQuality = 95;
    jpeg_set_quality(&codec, kQuality, TRUE);
    jpeg_start_compress(&codec, TRUE);
  });
  std::vector<unsigned char> values(3 * static_cast<std::size_t>(layout.width));
  for (int y = 0; y < layout.height; ++y) {
    row(y, values.data());
    unsigned char* line = values.data();
    calls.run([&] { jpeg_write_scanlines(&codec, &line, 1); });
  }
  calls.run([&] { jpeg_finish_compress(&codec); });
  return bytes;
}

}  // namespace ajar
