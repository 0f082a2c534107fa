#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "core/error.h"
#include "imageio/formats/image_formats.h"
#include "imageio/image_packing.h"

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
        throw ForeignImage("an HDR of the format " + line.substr(7));
      }
    }
    read_size(read_line());
  }

  int width() const { return is_turned_ ? rows_ : columns_; }
  int height() const { return is_turned_ ? columns_ : rows_; }
  /// Stored ones: of the picture, or its columns.
  int rows() const { return rows_; }
  int columns() const { return columns_; }
  bool runs_from_top_left() const { return !is_turned_ && goes_down_ && goes_right_; }

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
  explicit HdrDecoder(const std::string& path)
      : path_(path), reader_(std::make_unique<HdrReader>(path)) {
    ImageHeader& to = header_;
    to.width = reader_->width();
    to.height = reader_->height();
    to.channels = 3;
    to.names = {"R", "G", "B"};
    to.resolution = {to.width, to.height};
  }

  double most_pixels_per_byte() const override { return packing::kRuns; }
  std::uint64_t pixel_bytes() const override { return 3 * sizeof(float); }
  bool is_read_in_parts() const override { return true; }
  std::uint64_t working_bytes() const override {
    const std::uint64_t row =
        static_cast<std::uint64_t>(reader_->columns()) * (sizeof(Rgbe) + pixel_bytes());
    return row + (reader_->runs_from_top_left() ? 0 : header().pixels() * sizeof(Rgbe));
  }
  int block_height() const override { return 64; }

  void read_rows(int first, int rows, int first_channel, int channels, SampleType type,
                 void* values) override {
    const auto width = static_cast<std::size_t>(header().width);
    const ChannelPicker picker(3, first_channel, channels, type);
    floats_.resize(3 * width);
    if (!reader_->runs_from_top_left()) {
      if (whole_.empty()) read_whole();
      for (int y = first; y < first + rows; ++y) {
        pick(picker, whole_.data() + static_cast<std::size_t>(y) * width, width, values);
      }
      return;
    }
    if (first < next_) {
      reader_ = std::make_unique<HdrReader>(path_);
      next_ = 0;
    }
    row_.resize(width);
    for (; next_ < first + rows; ++next_) {
      reader_->read_row(row_);
      if (next_ < first) continue;
      pick(picker, row_.data(), width, values);
    }
  }

 private:
  void pick(const ChannelPicker& picker, const Rgbe* row, std::size_t width, void*& values) {
    for (std::size_t x = 0; x < width; ++x) {
      const Rgbe& pixel = row[x];
      const float scale = pixel[3] == 0 ? 0.F : std::ldexp(1.F, pixel[3] - (128 + 8));
      for (std::size_t c = 0; c < 3; ++c) floats_[3 * x + c] = static_cast<float>(pixel[c]) * scale;
    }
    picker.pick(floats_.data(), width, values);
  }

  /// The picture row by row from the top left, whatever the file has.
  void read_whole() {
    std::vector<Rgbe> whole(static_cast<std::size_t>(header().pixels()));
    row_.resize(static_cast<std::size_t>(reader_->columns()));
    for (int i = 0; i < reader_->rows(); ++i) {
      reader_->read_row(row_);
      for (int j = 0; j < reader_->columns(); ++j) {
        whole[reader_->place_of(i, j)] = row_[static_cast<std::size_t>(j)];
      }
    }
    whole_ = std::move(whole);
  }

  std::string path_;
  std::unique_ptr<HdrReader> reader_;
  int next_ = 0;
  std::vector<Rgbe> row_;
  std::vector<Rgbe> whole_;  ///< pixels of files that do not run from the top left
  std::vector<float> floats_;
};

}  // namespace

std::unique_ptr<ImageDecoder> open_hdr(const std::string& path) {
  return std::make_unique<HdrDecoder>(path);
}

}  // namespace ajar::image_formats
