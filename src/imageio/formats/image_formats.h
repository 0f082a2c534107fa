#pragma once
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "core/error.h"
#include "imageio/image_decoder.h"

/// Images by the libraries of their own formats: README.md.
namespace ajar::image_formats {

/// An image that nothing in this folder reads, but OpenImageIO may; the text says what it is.
class ForeignImage : public IoError {
 public:
  using IoError::IoError;
};

// One for each format. Raise ForeignImage, IoError, and what the libraries raise.
std::unique_ptr<ImageDecoder> open_exr(const std::string& path);
std::unique_ptr<ImageDecoder> open_png(const std::string& path, bool has_unassociated_alpha);
std::unique_ptr<ImageDecoder> open_jpeg(const std::string& path);
std::unique_ptr<ImageDecoder> open_hdr(const std::string& path);
/// By what the file begins with. Raises ForeignImage for all other formats.
std::unique_ptr<ImageDecoder> open_own(const std::string& path, bool has_unassociated_alpha);

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;
/// For reading. Raises IoError.
File open_file(const std::string& path);

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
        if constexpr (std::is_same_v<T, float>) return value;
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

}  // namespace ajar::image_formats
