#pragma once
#include <half.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "core/vector.h"

/// Readers of the formats of image files, in `formats/`. All but `ImageInput` open images through
/// that.
namespace ajar {

/// Type of the values of channels. Whole numbers stand for the range from 0 to 1.
enum class SampleType { UInt8, UInt16, Half, Float };

inline std::size_t size_of(SampleType type) {
  return type == SampleType::UInt8 ? 1 : type == SampleType::Float ? 4 : 2;
}

template <typename T>
constexpr SampleType sample_type_of() {
  if (std::is_same_v<T, std::uint8_t>) return SampleType::UInt8;
  if (std::is_same_v<T, std::uint16_t>) return SampleType::UInt16;
  if (std::is_same_v<T, Imath::half>) return SampleType::Half;
  static_assert(sizeof(T) <= sizeof(float) && (std::is_unsigned_v<T> || !std::is_integral_v<T>));
  return SampleType::Float;
}

/// Claims of an image file about its pixels.
struct ImageHeader {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<std::string> names;  ///< names of the channels, "R", "albedo.R", …
  int alpha_channel = -1;          ///< -1: there is none
  SampleType type = SampleType::Float;
  bool is_integer = false;
  /// True if it names other primaries than those of Rec. 709, as which all colours are taken.
  bool has_other_primaries = false;
  Vec2i origin{0, 0};      ///< place of the first pixel in the whole picture
  Vec2i resolution{0, 0};  ///< size of the whole picture
  std::map<std::string, std::string> texts;

  std::uint64_t pixels() const {
    return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  }
};

/// An open image file.
class ImageDecoder {
 public:
  ImageDecoder() = default;
  virtual ~ImageDecoder() = default;
  ImageDecoder(const ImageDecoder&) = delete;
  ImageDecoder& operator=(const ImageDecoder&) = delete;

  const ImageHeader& header() const { return header_; }
  /// More pixels cannot be packed into a byte of the file.
  virtual double most_pixels_per_byte() const = 0;
  /// Size of a pixel with all its channels, as the decoder keeps it.
  virtual std::uint64_t pixel_bytes() const = 0;
  /// True if it is read row by row, or block by block; else as a whole.
  virtual bool is_read_in_parts() const = 0;
  /// Most memory that reading rows takes beside them.
  virtual std::uint64_t working_bytes() const = 0;
  /// Rows that the file keeps together.
  virtual int block_height() const { return 64; }

  /// Rows from `first` on, the channels interleaved; `type` is the file's or Float. The strips of
  /// an image are asked for in their order. Raises IoError with the reason.
  virtual void read_rows(int first, int rows, int first_channel, int channels, SampleType type,
                         void* values) = 0;

 protected:
  /// Fills the header for the usual channels: Y, or R, G and B; and A if their number is
  /// even.
  void describe_pixels(int width, int height, int channels, SampleType type);
  /// Takes some channels out of a row that has them all, of the type that the header says, as they
  /// are or as floats: whole numbers then go from 0 to 1. `to`: the place of the row's first value
  /// among those that are wanted; after it, of the next.
  void pick(const void* row, int first_channel, int channels, SampleType type, void*& to) const;

  ImageHeader header_;
  int row_channels_ = 0;     ///< channels of rows to pick from, which may be more than the header's
  bool multiplies_ = false;  ///< multiplies the colours that it picks with alpha
};

/// Opens the first image of a file; what a file begins with says of which format it is.
/// `has_unassociated_alpha`: colours are not to be multiplied with alpha. Raises IoError with the
/// reason, and what the libraries raise.
std::unique_ptr<ImageDecoder> open_image(const std::string& path, bool has_unassociated_alpha);

}  // namespace ajar
