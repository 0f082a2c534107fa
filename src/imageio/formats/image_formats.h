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
inline constexpr double kDeflate = 8.0 * 1032.0;  ///< it makes at most so many bytes of one
inline constexpr double kUnknown = 1 << 20;       ///< fax code spends a bit on a white row
}  // namespace packing

template <typename T>
void multiply_with_alpha(T* row, std::size_t width, std::size_t channels, std::size_t alpha) {
  for (T* pixel = row; pixel < row + width * channels; pixel += channels) {
    for (std::size_t c = 0; c < channels; ++c) {
      if (c == alpha) continue;
      const auto value = static_cast<float>(pixel[c]);
      const auto opacity = static_cast<float>(pixel[alpha]);
      if constexpr (std::is_integral_v<T>) {
        constexpr float kWhole = static_cast<T>(-1);
        pixel[c] = static_cast<T>(value * (opacity / kWhole) + 0.5F);
      } else {
        pixel[c] = static_cast<T>(value * opacity);
      }
    }
  }
}

/// Takes some channels out of rows that have them all, as they are or as floats: whole numbers then
/// go from 0 to 1.
class ChannelPicker {
 public:
  ChannelPicker(int channels, int first, int count, SampleType wanted)
      : channels_(static_cast<std::size_t>(channels)),
        first_(static_cast<std::size_t>(first)),
        count_(static_cast<std::size_t>(count)),
        wanted_(wanted) {}

  /// `to`: the place of the row's first value among those that are wanted; after it, of the next.
  template <typename T>
  void pick(const T* row, std::size_t width, void*& to) const {
    if (wanted_ == SampleType::Float) {
      copy(row, width, static_cast<float*>(to), to, [](T value) {
        if constexpr (!std::is_integral_v<T>) return static_cast<float>(value);
        return static_cast<float>(value) * (1.F / static_cast<float>(static_cast<T>(-1)));
      });
    } else {
      copy(row, width, static_cast<T*>(to), to, [](T value) { return value; });
    }
  }

 private:
  template <typename T, typename U, typename Convert>
  void copy(const T* row, std::size_t width, U* out, void*& end, Convert convert) const {
    for (std::size_t x = 0; x < width; ++x) {
      const T* pixel = row + x * channels_ + first_;
      for (std::size_t c = 0; c < count_; ++c) *out++ = convert(pixel[c]);
    }
    end = out;
  }

  std::size_t channels_, first_, count_;
  SampleType wanted_;
};

/// Bytes that a library made, with what frees them.
using LibraryBytes = std::unique_ptr<unsigned char, void (*)(void*)>;

/// An image of 8 bits that its library decodes as a whole, when the first rows are asked for.
class WholeImageDecoder : public ImageDecoder {
 public:
  std::uint64_t pixel_bytes() const final { return static_cast<std::uint64_t>(stored_channels_); }
  bool is_read_in_parts() const final { return false; }
  void read_rows(int first, int rows, int first_channel, int channels, SampleType type,
                 void* values) final;

 protected:
  /// `stored_channels`: of what `decode` makes, if they are more than those of the header.
  void describe_whole(int width, int height, int channels, bool has_unassociated_alpha,
                      int stored_channels = 0);
  /// All pixels, row by row, with alpha as the file has it. Raises IoError.
  virtual LibraryBytes decode() = 0;

 private:
  int stored_channels_ = 0;
  bool multiplies_ = false;
  LibraryBytes bytes_{nullptr, nullptr};
};

}  // namespace ajar::image_formats
