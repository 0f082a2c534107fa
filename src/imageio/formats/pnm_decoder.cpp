#include <bit>
#include <cctype>
#include <limits>
#include <optional>

#include "core/error.h"
#include "core/number_text.h"
#include "imageio/formats/image_formats.h"

namespace ajar::image_formats {

namespace {

/// Reverses the bytes of each value.
template <typename T, typename Bits>
void swap_bytes(unsigned char* bytes, std::size_t size, Bits (*swapped)(Bits)) {
  auto* values = reinterpret_cast<T*>(bytes);
  for (std::size_t i = 0; i < size / sizeof(T); ++i) {
    values[i] = std::bit_cast<T>(swapped(std::bit_cast<Bits>(values[i])));
  }
}

/// Grey (P5, Pf) and colour (P6, PF): maps of 8 and big-endian 16 bits, and float maps of either
/// byte order with rows from the bottom. Sources: J. Poskanzer, "pgm" and "ppm"; P. Debevec's
/// description of PFM.
class PnmDecoder final : public ImageDecoder {
 public:
  explicit PnmDecoder(const std::string& path) : file_(open_file(path)) {
    // Four words, then exactly one white space, then the values.
    const std::string magic = word();
    const int channels = magic == "P6" || magic == "PF" ? 3 : 1;
    const int width = whole_number();
    const int height = whole_number();
    SampleType type = SampleType::Float;
    if (magic[1] == '5' || magic[1] == '6') {
      const int largest = whole_number();
      if (largest != 255 && largest != 65535) fail("its largest value is not 255 or 65535");
      type = largest == 255 ? SampleType::UInt8 : SampleType::UInt16;
    } else {
      const double scale = number();
      if (scale == 0.0) fail("bad header");
      has_other_byte_order_ = scale > 0.0;
      runs_from_bottom_ = true;
    }
    first_ = std::ftell(file_.get());
    describe_pixels(width, height, channels, type);
    row_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(pixel_bytes()));
  }

  double most_pixels_per_byte() const override { return 1.0 / static_cast<double>(pixel_bytes()); }
  std::uint64_t pixel_bytes() const override {
    return header().names.size() * size_of(header().type);
  }
  bool is_read_in_parts() const override { return true; }
  std::uint64_t working_bytes() const override { return row_.size(); }

  void read_rows(int first, int rows, int first_channel, int channels, SampleType type,
                 void* values) override {
    for (int y = first; y < first + rows; ++y) {
      read_row(runs_from_bottom_ ? header().height - 1 - y : y);
      pick(row_.data(), first_channel, channels, type, values);
    }
  }

 private:
  [[noreturn]] static void fail(const char* why) {
    throw IoError(std::string("the image is damaged (") + why + ")");
  }
  void read_row(int number) {
    std::fseek(file_.get(), first_ + number * static_cast<long>(row_.size()), SEEK_SET);
    if (std::fread(row_.data(), 1, row_.size(), file_.get()) != row_.size()) {
      fail("the file ends before the picture does");
    }
    if (header().type == SampleType::UInt16) {
      swap_bytes<std::uint16_t, std::uint16_t>(row_.data(), row_.size(),
                                               [](auto v) { return __builtin_bswap16(v); });
    } else if (has_other_byte_order_) {
      swap_bytes<float, std::uint32_t>(row_.data(), row_.size(),
                                       [](auto v) { return __builtin_bswap32(v); });
    }
  }

  /// With the white space that ends it. Remarks go from # to the end of the line.
  std::string word() {
    constexpr std::size_t kLongest = 32;
    std::string text;
    for (int c = 0; (c = std::getc(file_.get())) != EOF && text.size() < kLongest;) {
      if (c == '#' && text.empty()) {
        while (c != EOF && c != '\n') c = std::getc(file_.get());
      } else if (std::isspace(c) == 0) {
        text += static_cast<char>(c);
      } else if (!text.empty()) {
        break;
      }
    }
    return text;
  }
  double number() {
    const std::optional<double> value = number_of(word());
    if (!value) fail("bad header");
    return *value;
  }
  int whole_number() {
    constexpr double kMost = 1 << 20;
    const double value = number();
    if (!(value >= 1 && value <= kMost)) fail("bad header");
    return static_cast<int>(value);
  }

  static_assert(std::endian::native == std::endian::little);
  File file_;
  long first_ = 0;  ///< place of the values
  bool has_other_byte_order_ = false;
  bool runs_from_bottom_ = false;
  std::vector<unsigned char> row_;
};

}  // namespace

std::unique_ptr<ImageDecoder> open_pnm(const std::string& path) {
  return std::make_unique<PnmDecoder>(path);
}

}  // namespace ajar::image_formats
