#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "core/error.h"
#include "core/printable_text.h"
#include "imageio/formats/image_formats.h"

namespace ajar::image_formats {

namespace {

[[noreturn]] void fail(const std::string& what) {
  throw IoError("the image is damaged (" + what + ")");
}

using Rgbe = std::array<unsigned char, 4>;

/// Radiance's pictures. Source: G. Ward 1991, "Real Pixels", Graphics Gems II; Radiance's "Picture
/// File Format".
class HdrReader {
 public:
  explicit HdrReader(const std::string& path) : file_(open_file(path)) {
    for (std::string line = read_line(); !line.empty(); line = read_line()) {
      if (line.starts_with("FORMAT=") && line != "FORMAT=32-bit_rle_rgbe") {
        throw IoError("it is an HDR of the format " + printable_line(line.substr(7)) +
                      ", which is not read; 32-bit_rle_rgbe is");
      }
    }
    read_size(read_line());
  }

  int width() const { return is_turned_ ? rows_ : columns_; }
  int height() const { return is_turned_ ? columns_ : rows_; }
  /// Stored ones: of the picture, or its columns.
  int rows() const { return rows_; }
  int columns() const { return columns_; }

  /// Where the pixel `column` of a stored row is in the picture, row by row.
  std::size_t place_of(int row, int column) const {
    const int along_y = is_turned_ ? column : row;
    const int along_x = is_turned_ ? row : column;
    const int y = goes_down_ ? along_y : height() - 1 - along_y;
    const int x = goes_right_ ? along_x : width() - 1 - along_x;
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width()) +
           static_cast<std::size_t>(x);
  }

  void read_row(std::vector<Rgbe>& row) {
    constexpr int kLeast = 8;
    constexpr int kMost = 0x7fff;
    Rgbe first{};
    read(first);
    const bool is_new =
        columns_ >= kLeast && columns_ <= kMost && first[0] == 2 && first[1] == 2 && first[2] < 128;
    if (is_new) {
      if (first[2] * 256 + first[3] != columns_) fail("a row has another length");
      read_planes(row);
    } else {
      read_pixels(first, row);
    }
  }

 private:
  unsigned char read_byte() {
    const int byte = std::getc(file_.get());
    if (byte == EOF) fail("the file ends before the picture does");
    return static_cast<unsigned char>(byte);
  }
  void read(Rgbe& pixel) {
    for (unsigned char& byte : pixel) byte = read_byte();
  }
  std::string read_line() {
    constexpr std::size_t kLongest = 4096;
    std::string line;
    for (char c = 0; (c = static_cast<char>(read_byte())) != '\n';) {
      if (line.size() == kLongest) fail("a line of its header has no end");
      line += c;
    }
    return line;
  }

  /// Two signed axes with their lengths, as "-Y 2 +X 3": the second is along the stored rows.
  void read_size(std::string_view text) {
    const std::size_t second = text.find_first_of("+-", 1);
    const auto axis = [&](std::size_t place) {
      const bool is_axis = place < text.size() && text.substr(place).size() > 3 &&
                           (text[place] == '+' || text[place] == '-') && text[place + 2] == ' ';
      return is_axis ? text[place + 1] : ' ';
    };
    const char slow = axis(0);
    const char fast = axis(second);
    if ((slow != 'Y' || fast != 'X') && (slow != 'X' || fast != 'Y')) fail("it has no size");
    is_turned_ = slow == 'X';
    goes_right_ = text[is_turned_ ? 0 : second] == '+';
    goes_down_ = text[is_turned_ ? second : 0] == '-';
    const auto number = [&](std::string_view digits) {
      int value = 0;
      const auto [end, error] =
          std::from_chars(digits.data(), digits.data() + digits.size(), value);
      if (error != std::errc() || end != digits.data() + digits.size() || value < 1) {
        fail("it has no size");
      }
      return value;
    };
    const std::size_t end = text.find_last_not_of(' ', second - 1) + 1;
    rows_ = number(text.substr(3, end - 3));
    columns_ = number(text.substr(second + 3));
  }

  /// Each component of the row by itself, in runs.
  void read_planes(std::vector<Rgbe>& row) {
    for (std::size_t c = 0; c < 4; ++c) {
      for (std::size_t x = 0; x < row.size();) {
        const unsigned char code = read_byte();
        const std::size_t count = code > 128 ? code - 128U : code;
        if (count == 0 || count > row.size() - x) fail("a run leaves its row");
        unsigned char value = code > 128 ? read_byte() : static_cast<unsigned char>(0);
        for (const std::size_t end = x + count; x < end; ++x) {
          if (code <= 128) value = read_byte();
          row[x][c] = value;
        }
      }
    }
  }

  /// Pixel by pixel; 1, 1, 1, n repeats the one before, with more bits of n in those that follow.
  void read_pixels(Rgbe pixel, std::vector<Rgbe>& row) {
    unsigned shift = 0;
    for (std::size_t x = 0; x < row.size();) {
      if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
        const std::size_t count = shift < 32 ? std::size_t{pixel[3]} << shift : row.size() + 1;
        if (x == 0 || count > row.size() - x) fail("a run leaves its row");
        for (const std::size_t end = x + count; x < end; ++x) row[x] = row[x - 1];
        shift += 8;
      } else {
        row[x++] = pixel;
        shift = 0;
      }
      if (x < row.size()) read(pixel);
    }
  }

  File file_;
  int rows_ = 0;
  int columns_ = 0;
  bool is_turned_ = false;  ///< stored column by column
  bool goes_down_ = true;   ///< as y grows, with the next row or within it
  bool goes_right_ = true;
};

class HdrDecoder final : public ImageDecoder {
 public:
  explicit HdrDecoder(const std::string& path) : reader_(path) {
    describe_pixels(reader_.width(), reader_.height(), 3, SampleType::Float);
  }

  double most_pixels_per_byte() const override { return packing::kRuns; }
  std::uint64_t pixel_bytes() const override { return sizeof(Rgbe); }
  bool is_read_in_parts() const override { return false; }
  std::uint64_t working_bytes() const override {
    constexpr std::uint64_t kFloats = 3 * sizeof(float);
    return static_cast<std::uint64_t>(reader_.columns()) * sizeof(Rgbe) +
           static_cast<std::uint64_t>(header().width) * kFloats;
  }

  void read_rows(int first, int rows, int first_channel, int channels, SampleType type,
                 void* values) override {
    if (pixels_.empty()) read_pixels();
    const auto width = static_cast<std::size_t>(header().width);
    std::vector<float> floats(3 * width);
    for (int y = first; y < first + rows; ++y) {
      const Rgbe* row = pixels_.data() + static_cast<std::size_t>(y) * width;
      for (std::size_t i = 0; i < floats.size(); ++i) {
        const Rgbe& pixel = row[i / 3];
        const float scale = pixel[3] == 0 ? 0.F : std::ldexp(1.F, pixel[3] - (128 + 8));
        floats[i] = static_cast<float>(pixel[i % 3]) * scale;
      }
      pick(floats.data(), first_channel, channels, type, values);
    }
  }

 private:
  /// Row by row from the top left, whatever the file has.
  void read_pixels() {
    std::vector<Rgbe> pixels(static_cast<std::size_t>(header().pixels()));
    std::vector<Rgbe> row(static_cast<std::size_t>(reader_.columns()));
    for (int i = 0; i < reader_.rows(); ++i) {
      reader_.read_row(row);
      for (int j = 0; j < reader_.columns(); ++j) {
        pixels[reader_.place_of(i, j)] = row[static_cast<std::size_t>(j)];
      }
    }
    pixels_ = std::move(pixels);
  }

  HdrReader reader_;
  std::vector<Rgbe> pixels_;
};

}  // namespace

std::unique_ptr<ImageDecoder> open_hdr(const std::string& path) {
  return std::make_unique<HdrDecoder>(path);
}

}  // namespace ajar::image_formats
