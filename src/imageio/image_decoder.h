#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include "imageio/image_header.h"

/// What reads the formats of image files: `image_formats/`, and OpenImageIO (`image_openimageio/`)
/// for those that it leaves out. All but `ImageInput` open images through that.
namespace ajar {

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
  /// What is taken at most while rows are turned into what is asked for.
  virtual std::uint64_t working_bytes() const = 0;
  /// Rows that the file keeps together.
  virtual int block_height() const = 0;

  /// Rows from `first` on, the channels interleaved; `type` is the file's or Float. The strips of
  /// an image are asked for in their order. Raises IoError with the reason.
  virtual void read_rows(int first, int rows, int first_channel, int channels, SampleType type,
                         void* values) = 0;

 protected:
  ImageHeader header_;
};

/// Opens the first image of a file, of which the size is sane. `has_unassociated_alpha`: colours
/// are not to be multiplied with alpha. Raises IoError with the reason, and what the libraries
/// raise.
std::unique_ptr<ImageDecoder> open_image(const std::string& path, bool has_unassociated_alpha);

}  // namespace ajar
