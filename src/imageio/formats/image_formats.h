#pragma once
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "core/error.h"
#include "imageio/image_decoder.h"

/// Images by the libraries of their own formats: README.md.
namespace ajar::image_formats {

// One for each library. Raise IoError, and what the libraries raise.
std::unique_ptr<ImageDecoder> open_exr(const std::string& path);
std::unique_ptr<ImageDecoder> open_png(const std::string& path, bool has_unassociated_alpha);
std::unique_ptr<ImageDecoder> open_jpeg(const std::string& path);
std::unique_ptr<ImageDecoder> open_hdr(const std::string& path);
std::unique_ptr<ImageDecoder> open_pnm(const std::string& path);
std::unique_ptr<ImageDecoder> open_tiff(const std::string& path, bool has_unassociated_alpha);
std::unique_ptr<ImageDecoder> open_webp(const std::string& path, bool has_unassociated_alpha);
/// BMP, and Targa, which has no signature; empty if it is none of them.
std::unique_ptr<ImageDecoder> open_stb(const std::string& path, bool has_unassociated_alpha);

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;
/// For reading. Raises IoError.
File open_file(const std::string& path);

/// Bounds on how many pixels of an image a byte of its file can stand for, of one bit each where
/// formats have that. What has no such bound still says something about a row or a block of pixels.
namespace packing {
inline constexpr double kUnpacked = 8.0;
inline constexpr double kRuns = 8.0 * 64.0;       ///< PackBits and the like
inline constexpr double kDeflate = 8.0 * 1032.0;  ///< largest expansion of a byte
inline constexpr double kUnknown = 1 << 20;       ///< fax code spends a bit on a white row
}  // namespace packing

/// An image that its library decodes row by row, from the top.
class RowByRowDecoder : public ImageDecoder {
 public:
  void read_rows(int first, int rows, int first_channel, int channels, SampleType type,
                 void* values) final;

 protected:
  /// Goes back to the top.
  virtual void restart() = 0;
  virtual const void* next_row(int y) = 0;

 private:
  int next_ = 0;
};

/// Bytes that a library made, with what frees them.
using LibraryBytes = std::unique_ptr<unsigned char, void (*)(void*)>;

/// An image of 8 bits that its library decodes as a whole, when the first rows are asked for.
class WholeImageDecoder : public ImageDecoder {
 public:
  std::uint64_t pixel_bytes() const final { return static_cast<std::uint64_t>(row_channels_); }
  bool is_read_in_parts() const final { return false; }
  void read_rows(int first, int rows, int first_channel, int channels, SampleType type,
                 void* values) final;

 protected:
  /// All pixels, row by row, with alpha as the file has it. Raises IoError.
  virtual LibraryBytes decode() = 0;

 private:
  LibraryBytes bytes_{nullptr, nullptr};
};

}  // namespace ajar::image_formats
