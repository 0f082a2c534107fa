#include "imageio/image_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <limits>
#include <new>
#include <stdexcept>

#include "core/error.h"
#include "core/printable_text.h"
#include "os/available_memory.h"
#include "os/regular_file.h"

namespace ajar {

namespace {

/// Runs something of the library, whose decoders raise all kinds of exceptions.
template <typename Call>
auto guarded(const Call& call) {
  try {
    return call();
  } catch (const std::bad_alloc&) {
    throw IoError("the image does not fit into memory");
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    throw IoError("the image is damaged (" + printable_line(error.what()) + ")");
  }
}

}  // namespace

ImageInput::ImageInput(const std::string& path, bool has_unassociated_alpha) {
  if (const std::string complaint = reading_complaint(path); !complaint.empty()) {
    throw IoError(complaint);
  }
  std::error_code error;
  const std::uint64_t file_bytes = std::filesystem::file_size(path, error);
  if (error || file_bytes == 0) throw IoError("the file is empty");
  decoder_ = guarded([&] { return open_image(path, has_unassociated_alpha); });
  if (header().width <= 0 || header().height <= 0 || header().channels < 1) {
    throw IoError("it is not a flat image with pixels");
  }
  if (static_cast<double>(header().pixels()) >
      decoder_->most_pixels_per_byte() * static_cast<double>(file_bytes)) {
    throw IoError(fmt::format("it claims {}x{} pixels, but has {} bytes, which cannot hold them",
                              header().width, header().height, file_bytes));
  }
  colors_ = color_channels(header().names);
  if (colors_.alpha < 0) colors_.alpha = header().alpha_channel;
  // Libraries count them with int.
  if (static_cast<std::uint64_t>(header().width) * decoder_->pixel_bytes() >
      static_cast<std::uint64_t>(std::numeric_limits<int>::max())) {
    throw IoError(fmt::format("its rows of {} pixels are too long", header().width));
  }
}

std::uint64_t ImageInput::bytes(int channels, std::uint64_t channel_bytes) const {
  const std::uint64_t pixels = header().pixels();
  const std::uint64_t own = pixels * static_cast<std::uint64_t>(channels) * channel_bytes;
  return own + (decoder_->is_read_in_parts() ? 0 : pixels * decoder_->pixel_bytes());
}

void ImageInput::check_memory(std::uint64_t bytes) {
  if (const std::string preparation_cut = memory_shortage(bytes); !preparation_cut.empty()) {
    throw IoError("the image " + preparation_cut);
  }
}

int ImageInput::strip_height() const {
  // Whole blocks of rows, as files keep them, and enough of them to decode on all threads.
  constexpr std::uint64_t kStripBytes = std::uint64_t{1} << 26U;
  const int block = decoder_->block_height();
  const std::uint64_t row = static_cast<std::uint64_t>(header().width) *
                            std::max<std::uint64_t>(decoder_->pixel_bytes(), 1);
  const std::uint64_t block_bytes = static_cast<std::uint64_t>(block) * row;
  return block * static_cast<int>(std::clamp<std::uint64_t>(kStripBytes / block_bytes, 1, 1024));
}

void ImageInput::read_strip(int first, int rows, int first_channel, int channels, SampleType type,
                            void* values) {
  // Decoders write values of the size that they have, wherever they were asked for others.
  if (type != header().type && type != SampleType::Float) {
    throw std::invalid_argument("ImageInput: asked for values of a type that the file has not");
  }
  guarded([&] { decoder_->read_rows(first, rows, first_channel, channels, type, values); });
}

}  // namespace ajar
