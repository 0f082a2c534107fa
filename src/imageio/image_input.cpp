#include "imageio/image_input.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <limits>
#include <new>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "core/error.h"
#include "imageio/exr_header.h"
#include "imageio/image_complaint.h"
#include "imageio/image_packing.h"
#include "imageio/png_chunks.h"
#include "imageio/unsafe_formats.h"
#include "os/available_memory.h"
#include "os/regular_file.h"

namespace ajar {

namespace {

struct Size {
  std::uint64_t width, height;
};

/// What a file claims to hold, and how much of it a byte can stand for.
struct Claim {
  Size size;
  double pixels_per_byte;
};

/// How a file begins.
std::string beginning_of(const std::string& path) {
  std::array<char, 64> bytes{};
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) return {};
  const ssize_t count = ::read(file, bytes.data(), bytes.size());
  ::close(file);
  return {bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0))};
}

/// A little-endian number of `count` bytes; 0 beyond the end.
std::uint64_t little_endian_at(std::string_view bytes, std::size_t place, std::size_t count) {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < count && place + i < bytes.size(); ++i) {
    number |= std::uint64_t{static_cast<unsigned char>(bytes[place + i])} << (8 * i);
  }
  return number;
}

/// Of WebP, or of one of its two bitstreams without a container, which the decoder takes, too.
/// Source: RFC 9649, sections 2.5 to 2.7 and 3.4; RFC 6386, section 9.1.
std::optional<Claim> claim_of_webp(std::string_view bytes) {
  if (bytes.starts_with("RIFF")) {
    if (bytes.size() < 30 || !bytes.substr(8).starts_with("WEBP")) return std::nullopt;
    if (bytes.substr(12).starts_with("VP8X")) {
      return Claim{{little_endian_at(bytes, 24, 3) + 1, little_endian_at(bytes, 27, 3) + 1},
                   packing::kVp8Lossless};
    }
    bytes.remove_prefix(20);
  }
  if (bytes.size() < 10) return std::nullopt;
  if (bytes.starts_with("\x2f")) {
    const std::uint64_t sides = little_endian_at(bytes, 1, 4);
    return Claim{{(sides & 0x3fffU) + 1, (sides >> 14U & 0x3fffU) + 1}, packing::kVp8Lossless};
  }
  if (!bytes.substr(3).starts_with("\x9d\x01\x2a")) return std::nullopt;
  return Claim{{little_endian_at(bytes, 6, 2) & 0x3fffU, little_endian_at(bytes, 8, 2) & 0x3fffU},
               packing::kVp8};
}

/// What formats claim whose decoders make the whole picture when they are opened: those have to be
/// asked before.
std::optional<Claim> early_claim(std::string_view bytes) {
  const auto has = [&](std::string_view text, std::size_t place) {
    return bytes.size() >= place && bytes.substr(place).starts_with(text);
  };
  // The decoder does not mind the version that follows.
  if (has("GIF", 0))
    return Claim{{little_endian_at(bytes, 6, 2), little_endian_at(bytes, 8, 2)}, packing::kLzw};
  if (has("BM", 0) && little_endian_at(bytes, 14, 4) >= 40) {
    const auto side = [&](std::size_t place) {
      const auto value = static_cast<std::int32_t>(little_endian_at(bytes, place, 4));
      return static_cast<std::uint64_t>(std::abs(std::int64_t{value}));
    };
    constexpr double kSkips = 255.0 * 255.0 / 4.0;  // rows and columns that four bytes leave out
    return Claim{{side(18), side(22)}, kSkips};
  }
  return claim_of_webp(bytes);
}

void check_claim(Size size, double pixels_per_byte, std::uint64_t file_bytes) {
  const double pixels = static_cast<double>(size.width) * static_cast<double>(size.height);
  if (pixels <= pixels_per_byte * static_cast<double>(file_bytes)) return;
  throw IoError(fmt::format("it claims {}x{} pixels, but has {} bytes, which cannot hold them",
                            size.width, size.height, file_bytes));
}

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
    throw IoError("the image is damaged (" + image_complaint(error.what()) + ")");
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
  if (const auto claim = early_claim(beginning_of(path))) {
    constexpr std::uint64_t kDecodedBytes = 12;  // 4 channels, and as much again twice
    // A canvas may be larger than the picture on it: this much is believed of any file.
    constexpr std::uint64_t kSmall = std::uint64_t{1} << 24U;
    const std::uint64_t pixels = claim->size.width * claim->size.height;
    if (pixels > kSmall) check_claim(claim->size, claim->pixels_per_byte, file_bytes);
    check_memory(kDecodedBytes * pixels);
  }
  for (const auto complain : {exr_header_complaint, png_chunk_complaint, unsafe_format_complaint}) {
    if (const std::string complaint = complain(path, file_bytes); !complaint.empty()) {
      throw IoError(complaint);
    }
  }
  decoder_ = guarded([&] { return open_image(path, has_unassociated_alpha); });
  if (header().width <= 0 || header().height <= 0 || header().channels < 1) {
    throw IoError("it is not a flat image with pixels");
  }
  check_claim(
      {static_cast<std::uint64_t>(header().width), static_cast<std::uint64_t>(header().height)},
      decoder_->most_pixels_per_byte(), file_bytes);
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
  if (const std::string shortage = memory_shortage(bytes); !shortage.empty()) {
    throw IoError("the image " + shortage);
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
