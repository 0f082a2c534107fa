#pragma once
#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "imageio/color_channels.h"
#include "imageio/image_decoder.h"

/// Image files as all rooms open them: with what a header claims held against the size of the file
/// and the memory there is, before anything is made of that size. Errors are IoErrors whose message
/// is the reason alone, for the caller to name the file and its place.
namespace ajar {

/// An open image. Of several in a file it is the first; of the parts of an EXR, the picture, with
/// the others as its layers.
class ImageInput {
 public:
  /// `has_unassociated_alpha`: colours are not to be multiplied with alpha. Raises IoError if this
  /// is no regular file, no image, or claims more pixels than its bytes can hold.
  explicit ImageInput(const std::string& path, bool has_unassociated_alpha = false);

  const ImageHeader& header() const { return decoder_->header(); }
  /// The channels that are the picture.
  const ColorChannels& colors() const { return colors_; }
  /// Memory of the first `channels` channels, and of what the decoder needs for them, bytes.
  std::uint64_t bytes(int channels, std::uint64_t channel_bytes) const;

  /// The first `channels` channels of all pixels, interleaved, as floats or as the file has them;
  /// other types raise std::invalid_argument. Raises IoError if they cannot be read, or with
  /// `extra_bytes` more need more memory than there is.
  template <typename T>
  std::vector<T> read(int channels, std::uint64_t extra_bytes = 0) {
    return read_from<T>(0, channels, extra_bytes);
  }
  /// Reads from channel `first_channel` on.
  template <typename T>
  std::vector<T> read_from(int first_channel, int channels, std::uint64_t extra_bytes = 0) {
    check_memory(bytes(channels, sizeof(T)) + decoder_->working_bytes() + extra_bytes);
    std::vector<T> values;
    const std::size_t row =
        static_cast<std::size_t>(header().width) * static_cast<std::size_t>(channels);
    values.reserve(row * static_cast<std::size_t>(header().height));
    // Bytes come as the file gives them: memory that was only reserved is not in use yet.
    for (int y = 0; y < header().height; y += strip_height()) {
      const int rows = std::min(strip_height(), header().height - y);
      const std::size_t first = values.size();
      values.resize(first + row * static_cast<std::size_t>(rows));
      read_strip(y, rows, first_channel, channels, sample_type_of<T>(), values.data() + first);
    }
    return values;
  }

 private:
  static void check_memory(std::uint64_t bytes);
  int strip_height() const;
  void read_strip(int first, int rows, int first_channel, int channels, SampleType type,
                  void* values);

  std::unique_ptr<ImageDecoder> decoder_;
  ColorChannels colors_;
};

}  // namespace ajar
