#include <tiffio.h>

#include <algorithm>
#include <cstdarg>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "core/printable_text.h"
#include "imageio/formats/image_formats.h"

namespace ajar::image_formats {

namespace {

/// The library's handle, and what it last complained of. It prints nothing.
class TiffFile {
 public:
  explicit TiffFile(const std::string& path) {
    const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(
        TIFFOpenOptionsAlloc(), TIFFOpenOptionsFree);
    if (!options) throw std::bad_alloc();
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), on_error, this);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), on_warning, nullptr);
    // Not mapped into memory: a file may become shorter.
    tiff_ = TIFFOpenExt(path.c_str(), "rm", options.get());
    if (tiff_ == nullptr) fail();
  }
  ~TiffFile() { TIFFClose(tiff_); }
  TiffFile(const TiffFile&) = delete;
  TiffFile& operator=(const TiffFile&) = delete;

  TIFF* get() const { return tiff_; }
  template <typename T>
  T field(ttag_t tag, T absent) const {
    T value = absent;
    return TIFFGetFieldDefaulted(tiff_, tag, &value) == 1 ? value : absent;
  }
  [[noreturn]] void fail() const {
    throw IoError("the image is damaged (" + printable_line(complaint_) + ")");
  }

 private:
  static int on_error(TIFF*, void* file, const char*, const char* format, va_list arguments) {
    char text[256] = {};
    std::vsnprintf(text, sizeof(text), format, arguments);
    static_cast<TiffFile*>(file)->complaint_ = text;
    return 1;
  }
  static int on_warning(TIFF*, void*, const char*, const char*, va_list) { return 1; }

  TIFF* tiff_ = nullptr;
  std::string complaint_ = "libtiff does not say why";
};

/// Values of its tags.
struct TiffTags {
  int width, height;
  int samples, bits, format;
  int colors;  ///< PHOTOMETRIC_…
  int compression;
  bool has_planes;

  explicit TiffTags(const TiffFile& file)
      : width(side(file, TIFFTAG_IMAGEWIDTH)),
        height(side(file, TIFFTAG_IMAGELENGTH)),
        samples(number(file, TIFFTAG_SAMPLESPERPIXEL)),
        bits(number(file, TIFFTAG_BITSPERSAMPLE)),
        format(number(file, TIFFTAG_SAMPLEFORMAT)),
        colors(number(file, TIFFTAG_PHOTOMETRIC,
                      samples < 3 ? PHOTOMETRIC_MINISBLACK : PHOTOMETRIC_RGB)),
        compression(number(file, TIFFTAG_COMPRESSION)),
        has_planes(number(file, TIFFTAG_PLANARCONFIG) == PLANARCONFIG_SEPARATE) {
    if (width < 1 || height < 1 || file.field<std::uint32_t>(TIFFTAG_IMAGEDEPTH, 1) > 1) {
      throw IoError("it is not a flat image with pixels");
    }
    // The library makes red, green and blue of them itself.
    if (compression == COMPRESSION_JPEG && colors == PHOTOMETRIC_YCBCR && !has_planes) {
      TIFFSetField(file.get(), TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
      colors = PHOTOMETRIC_RGB;
    }
  }

  bool is_integer() const { return format == SAMPLEFORMAT_UINT || format == SAMPLEFORMAT_VOID; }
  bool is_float() const { return format == SAMPLEFORMAT_IEEEFP; }
  bool is_gray() const { return colors == PHOTOMETRIC_MINISBLACK; }
  /// True if its samples are grey or RGB of a type that is kept.
  bool is_plain() const {
    return ((is_gray() && samples >= 1) || (colors == PHOTOMETRIC_RGB && samples >= 3)) &&
           ((is_integer() && (bits == 8 || bits == 16)) ||
            (is_float() && (bits == 16 || bits == 32)));
  }
  SampleType type() const {
    if (is_float()) return bits == 16 ? SampleType::Half : SampleType::Float;
    return bits == 8 ? SampleType::UInt8 : SampleType::UInt16;
  }
  double most_pixels_per_byte() const {
    constexpr double kLzw = 8.0 * 2560.0;  // 12-bit codes of a full table
    if (compression == COMPRESSION_NONE) return packing::kUnpacked;
    if (compression == COMPRESSION_PACKBITS) return packing::kRuns;
    if (compression == COMPRESSION_LZW) return kLzw;
    const bool is_deflate =
        compression == COMPRESSION_ADOBE_DEFLATE || compression == COMPRESSION_DEFLATE;
    return is_deflate ? packing::kDeflate : packing::kUnknown;
  }

 private:
  static int side(const TiffFile& file, ttag_t tag) {
    return static_cast<int>(std::min<std::uint32_t>(file.field<std::uint32_t>(tag, 0),
                                                    std::numeric_limits<int>::max()));
  }
  static int number(const TiffFile& file, ttag_t tag, int absent = 0) {
    return file.field<std::uint16_t>(tag, static_cast<std::uint16_t>(absent));
  }
};

/// A strip or tile: what is decoded at a time.
struct TiffBlock {
  int width, height;
  std::size_t bytes;
  bool is_tile;

  TiffBlock(const TiffFile& file, const TiffTags& tags)
      : width(tags.width), is_tile(TIFFIsTiled(file.get()) != 0) {
    if (is_tile) width = side(file, TIFFTAG_TILEWIDTH, tags.width);
    height = side(file, is_tile ? TIFFTAG_TILELENGTH : TIFFTAG_ROWSPERSTRIP, tags.height);
    bytes = static_cast<std::size_t>(is_tile ? TIFFTileSize(file.get())
                                             : TIFFVStripSize(file.get(), rows(tags)));
    if (width < 1 || height < 1 || bytes == 0) file.fail();
  }
  /// Rows of a block, without those beyond the picture.
  std::uint32_t rows(const TiffTags& tags) const {
    return static_cast<std::uint32_t>(std::min(height, tags.height));
  }

 private:
  static int side(const TiffFile& file, ttag_t tag, int absent) {
    constexpr std::uint32_t kMost = 1U << 30U;
    return static_cast<int>(
        std::min(file.field<std::uint32_t>(tag, static_cast<std::uint32_t>(absent)), kMost));
  }
};

class TiffDecoder final : public ImageDecoder {
 public:
  TiffDecoder(std::unique_ptr<TiffFile> file, const TiffTags& tags, bool has_unassociated_alpha)
      : file_(std::move(file)), tags_(tags), block_(*file_, tags) {
    describe_pixels(tags.width, tags.height, std::min(tags.samples, 4), tags.type());
    header_.channels = row_channels_ = tags.samples;
    for (int i = 4; i < tags.samples; ++i) name_channel(i);
    if (block_.bytes / block_.rows(tags) < stored_row_bytes()) file_->fail();
    std::uint16_t count = 0;
    const std::uint16_t* meanings = nullptr;
    TIFFGetFieldDefaulted(file_->get(), TIFFTAG_EXTRASAMPLES, &count, &meanings);
    const int first = tags.is_gray() ? 1 : 3;
    // Files that do not say what a single one is mean alpha.
    if (count == 1 && meanings[0] == EXTRASAMPLE_UNSPECIFIED) count = 0;
    if (count > 0) header_.alpha_channel = -1;
    for (int i = first; i < std::min(first + count, tags.samples); ++i) {
      const std::uint16_t meaning = meanings[i - first];
      const bool is_alpha = meaning == EXTRASAMPLE_ASSOCALPHA || meaning == EXTRASAMPLE_UNASSALPHA;
      if (is_alpha && header_.alpha_channel < 0) {
        header_.alpha_channel = i;
        header_.names[static_cast<std::size_t>(i)] = "A";
        multiplies_ = meaning == EXTRASAMPLE_UNASSALPHA && !has_unassociated_alpha;
      } else {
        name_channel(i);
      }
    }
  }

  double most_pixels_per_byte() const override { return tags_.most_pixels_per_byte(); }
  std::uint64_t pixel_bytes() const override {
    return header().names.size() * size_of(header().type);
  }
  bool is_read_in_parts() const override { return true; }
  std::uint64_t working_bytes() const override {
    return block_.bytes + static_cast<std::uint64_t>(block_.rows(tags_)) * row_bytes();
  }
  int block_height() const override { return static_cast<int>(block_.rows(tags_)); }

  void read_rows(int first, int rows, int first_channel, int channels, SampleType type,
                 void* values) override {
    const int end = first + rows;
    for (int top = first / block_.height * block_.height; top < end; top += block_.height) {
      read_blocks(top);
      const int bottom = std::min(top + block_.height, end);
      for (int y = std::max(top, first); y < bottom; ++y) {
        pick(rows_.data() + static_cast<std::size_t>(y - top) * row_bytes(), first_channel,
             channels, type, values);
      }
    }
  }

 private:
  void name_channel(int i) {
    const std::string name = "channel" + std::to_string(i);
    if (static_cast<std::size_t>(i) < header_.names.size()) {
      header_.names[static_cast<std::size_t>(i)] = name;
    } else {
      header_.names.push_back(name);
    }
  }
  std::size_t row_bytes() const {
    return static_cast<std::size_t>(header().width) * static_cast<std::size_t>(pixel_bytes());
  }
  /// Size of a row of a block, with all samples or those of a plane.
  std::size_t stored_row_bytes() const {
    const std::uint64_t pixel = tags_.has_planes ? size_of(header().type) : pixel_bytes();
    return static_cast<std::size_t>(block_.width) * static_cast<std::size_t>(pixel);
  }

  /// Fills `rows_` with those of the blocks that begin at this row.
  void read_blocks(int top) {
    const int rows = std::min(block_.height, tags_.height - top);
    rows_.resize(static_cast<std::size_t>(block_.rows(tags_)) * row_bytes());
    stored_.resize(block_.bytes);
    const std::size_t sample = size_of(header().type);
    const auto pixel = static_cast<std::size_t>(pixel_bytes());
    const std::size_t stride = stored_row_bytes();
    for (int plane = 0; plane < (tags_.has_planes ? tags_.samples : 1); ++plane) {
      for (int left = 0; left < tags_.width; left += block_.width) {
        read_block(left, top, plane);
        const auto columns = static_cast<std::size_t>(std::min(block_.width, tags_.width - left));
        for (int y = 0; y < rows; ++y) {
          const unsigned char* from = stored_.data() + static_cast<std::size_t>(y) * stride;
          unsigned char* to = rows_.data() + static_cast<std::size_t>(y) * row_bytes() +
                              static_cast<std::size_t>(left) * pixel +
                              static_cast<std::size_t>(plane) * sample;
          if (tags_.has_planes) {
            for (std::size_t x = 0; x < columns; ++x) {
              std::memcpy(to + x * pixel, from + x * sample, sample);
            }
          } else {
            std::memcpy(to, from, columns * pixel);
          }
        }
      }
    }
  }

  void read_block(int left, int top, int plane) {
    const auto x = static_cast<std::uint32_t>(left);
    const auto y = static_cast<std::uint32_t>(top);
    const auto p = static_cast<std::uint16_t>(plane);
    const auto size = static_cast<tmsize_t>(stored_.size());
    TIFF* const tiff = file_->get();
    const tmsize_t count =
        block_.is_tile
            ? TIFFReadEncodedTile(tiff, TIFFComputeTile(tiff, x, y, 0, p), stored_.data(), size)
            : TIFFReadEncodedStrip(tiff, TIFFComputeStrip(tiff, y, p), stored_.data(), size);
    if (count < 0) file_->fail();
  }

  std::unique_ptr<TiffFile> file_;
  TiffTags tags_;
  TiffBlock block_;
  std::vector<unsigned char> stored_;  ///< a block
  std::vector<unsigned char> rows_;    ///< all channels of all blocks beside each other
};

/// Palettes, few bits, CMYK and the like, of which the library makes 8 bits.
class TiffColorDecoder final : public WholeImageDecoder {
 public:
  TiffColorDecoder(std::unique_ptr<TiffFile> file, const TiffTags& tags)
      : file_(std::move(file)), tags_(tags), block_(*file_, tags) {
    char reason[1024] = {};
    if (!tags.is_integer() || TIFFRGBAImageOK(file_->get(), reason) == 0) {
      throw IoError(
          "its samples of " + std::to_string(tags.bits) +
          " bits, or its colours, are of a kind that is not read; 8 and 16 bits without a sign and "
          "floating-point numbers of 16 and 32 bits are, in grey or RGB");
    }
    const bool is_gray = tags.is_gray() || tags.colors == PHOTOMETRIC_MINISWHITE;
    describe_pixels(tags.width, tags.height, is_gray ? 1 : 3, SampleType::UInt8);
    row_channels_ = 4;
  }

  double most_pixels_per_byte() const override { return tags_.most_pixels_per_byte(); }
  std::uint64_t working_bytes() const override { return 2 * block_.bytes; }

 private:
  LibraryBytes decode() override {
    LibraryBytes pixels(static_cast<unsigned char*>(std::calloc(header().pixels(), 4)), std::free);
    if (!pixels) throw std::bad_alloc();
    // The orientation tag is ignored, as for other formats.
    TIFFSetField(file_->get(), TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
    if (TIFFReadRGBAImageOriented(file_->get(), static_cast<std::uint32_t>(tags_.width),
                                  static_cast<std::uint32_t>(tags_.height),
                                  reinterpret_cast<std::uint32_t*>(pixels.get()),
                                  ORIENTATION_TOPLEFT, 1) == 0) {
      file_->fail();
    }
    return pixels;
  }

  std::unique_ptr<TiffFile> file_;
  TiffTags tags_;
  TiffBlock block_;
};

}  // namespace

std::unique_ptr<ImageDecoder> open_tiff(const std::string& path, bool has_unassociated_alpha) {
  auto file = std::make_unique<TiffFile>(path);
  const TiffTags tags(*file);
  if (tags.is_plain()) {
    return std::make_unique<TiffDecoder>(std::move(file), tags, has_unassociated_alpha);
  }
  return std::make_unique<TiffColorDecoder>(std::move(file), tags);
}

}  // namespace ajar::image_formats
