#include "imageio/image_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <memory>
#include <new>
#include <stdexcept>
#include <string_view>

#include "core/error.h"
#include "imageio/color_channels.h"
#include "imageio/image_encoder.h"
#include "imageio/image_input.h"
#include "os/atomic_file.h"
#include "os/file_extension.h"

namespace ajar {

namespace {
constexpr std::array<const char*, 6> kExtensions = {".exr",  ".png", ".jpg",
                                                    ".jpeg", ".pfm", ".hdr"};
/// Largest finite value of the RGBE encoding is near 2^127.
constexpr float kLargestHdr = 1e38F;

bool is_display_format(const std::string& extension) {
  return extension == ".png" || extension == ".jpg" || extension == ".jpeg";
}

void check_layers(const Picture& picture) {
  const std::size_t pixels = static_cast<std::size_t>(picture.crop.max.x - picture.crop.min.x + 1) *
                             static_cast<std::size_t>(picture.crop.max.y - picture.crop.min.y + 1);
  if (picture.crop.isEmpty() || picture.layers.empty())
    throw std::invalid_argument("write_image: nothing to write");
  for (const Picture::Layer& layer : picture.layers) {
    if ((layer.channels != 1 && layer.channels != 3) ||
        layer.pixels.size() != pixels * static_cast<std::size_t>(layer.channels)) {
      throw std::invalid_argument("write_image: layer \"" + layer.name +
                                  "\" does not fit the crop");
    }
  }
}

ImageLayout layout_of(const Picture& picture, std::span<const Picture::Layer> layers) {
  ImageLayout layout;
  layout.width = picture.crop.max.x - picture.crop.min.x + 1;
  layout.height = picture.crop.max.y - picture.crop.min.y + 1;
  layout.origin = picture.crop.min;
  layout.resolution = picture.resolution;
  layout.texts = picture.metadata;
  for (const Picture::Layer& layer : layers) {
    const std::string prefix = layer.name.empty() ? "" : layer.name + ".";
    if (layer.channels == 1) layout.names.push_back(layer.name.empty() ? "Y" : layer.name);
    if (layer.channels == 3) {
      for (const char* channel : {"R", "G", "B"}) layout.names.push_back(prefix + channel);
    }
  }
  return layout;
}

std::span<const float> row_of_first_layer(const Picture& picture, int y) {
  const std::size_t row = static_cast<std::size_t>(picture.crop.max.x - picture.crop.min.x + 1) * 3;
  return std::span(picture.layers[0].pixels).subspan(static_cast<std::size_t>(y) * row, row);
}

std::vector<unsigned char> exr_bytes(const Picture& picture) {
  const ImageLayout layout = layout_of(picture, picture.layers);
  const auto width = static_cast<std::size_t>(layout.width);
  return encode_exr(layout, [&](int y, float* out) {
    std::size_t channel = 0;
    for (const Picture::Layer& layer : picture.layers) {
      const auto channels = static_cast<std::size_t>(layer.channels);
      const float* in = layer.pixels.data() + static_cast<std::size_t>(y) * width * channels;
      for (std::size_t x = 0; x < width; ++x) {
        std::copy_n(in + x * channels, channels, out + x * layout.names.size() + channel);
      }
      channel += channels;
    }
  });
}

std::vector<unsigned char> hdr_bytes(const Picture& picture) {
  return encode_hdr(layout_of(picture, std::span(picture.layers).first(1)), [&](int y, float* out) {
    // Written so that NaN becomes zero.
    const auto rgb = row_of_first_layer(picture, y);
    std::transform(rgb.begin(), rgb.end(), out,
                   [](float v) { return v > 0.F ? std::min(v, kLargestHdr) : 0.F; });
  });
}

std::vector<unsigned char> pfm_bytes(const Picture& picture) {
  return encode_pfm(layout_of(picture, std::span(picture.layers).first(1)), [&](int y, float* out) {
    const auto rgb = row_of_first_layer(picture, y);
    std::copy(rgb.begin(), rgb.end(), out);
  });
}

std::vector<unsigned char> display_bytes(const Picture& picture, const std::string& extension) {
  ImageLayout layout = layout_of(picture, std::span(picture.layers).first(1));
  const auto width = static_cast<std::size_t>(layout.width);
  const bool is_png = extension == ".png";
  const Picture::Layer* const alpha = is_png ? alpha_of(picture) : nullptr;
  if (alpha != nullptr) layout.names.emplace_back(kAlphaLayer);
  const std::size_t channels = layout.names.size();
  const auto encode = is_png ? encode_png : encode_jpeg;
  return encode(layout, [&](int y, unsigned char* out) {
    const auto byte_of = [](float v) {
      // Written so that NaN becomes zero.
      return static_cast<unsigned char>(v > 0.F ? std::lround(std::min(v, 1.F) * 255.F) : 0);
    };
    const std::size_t first = static_cast<std::size_t>(y) * width;
    for (std::size_t x = 0; x < width; ++x) {
      const float* in = picture.layers[0].pixels.data() + 3 * (first + x);
      std::transform(in, in + 3, out + channels * x, byte_of);
      if (alpha != nullptr) out[channels * x + 3] = byte_of(alpha->pixels[first + x]);
    }
  });
}

std::vector<unsigned char> encoded(const std::string& path, const Picture& picture) {
  const std::string extension = file_extension(path);
  try {
    if (extension == ".exr") return exr_bytes(picture);
    if (extension == ".pfm") return pfm_bytes(picture);
    return is_display_format(extension) ? display_bytes(picture, extension) : hdr_bytes(picture);
  } catch (const IoError& error) {
    throw IoError("cannot write \"" + path + "\": " + error.what());
  }
}

std::vector<float> gather(const Image& image, const std::array<std::ptrdiff_t, 3>& channels) {
  std::vector<float> rgb;
  const std::size_t pixels =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  rgb.reserve(pixels * 3);
  for (std::size_t i = 0; i < pixels; ++i) {
    for (const std::ptrdiff_t c : channels) {
      rgb.push_back(
          image.data[i * static_cast<std::size_t>(image.channels) + static_cast<std::size_t>(c)]);
    }
  }
  return rgb;
}
}  // namespace

float Image::at(int x, int y, int channel) const {
  return data[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x)) *
                  static_cast<std::size_t>(channels) +
              static_cast<std::size_t>(channel)];
}

std::vector<float> Image::rgb(const std::string& layer) const {
  const auto find = [&](const std::string& name) -> std::ptrdiff_t {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? -1 : found - names.begin();
  };
  const std::string prefix = layer.empty() ? "" : layer + ".";
  const std::array<std::ptrdiff_t, 3> colour = {find(prefix + "R"), find(prefix + "G"),
                                                find(prefix + "B")};
  if (colour[0] >= 0 && colour[1] >= 0 && colour[2] >= 0) return gather(*this, colour);
  if (layer.empty()) {
    const ColorChannels picture = color_channels(names);
    if (!picture.remark.empty()) return {};
    const std::ptrdiff_t step = picture.count == 3 ? 1 : 0;
    return gather(*this, {picture.first, picture.first + step, picture.first + 2 * step});
  }
  for (const std::string& name : {layer, prefix + "Y", prefix + "Z"}) {
    if (const std::ptrdiff_t grey = find(name); grey >= 0) return gather(*this, {grey, grey, grey});
  }
  return {};
}

Image read_image(const std::string& path) {
  try {
    ImageInput input(path);
    const ImageHeader& header = input.header();
    Image image;
    image.width = header.width;
    image.height = header.height;
    image.channels = header.channels;
    image.names = header.names;
    image.origin = header.origin;
    image.resolution = header.resolution;
    image.is_display_encoded = header.is_integer;
    constexpr std::string_view kOurs = "ajar:";
    for (const auto& [name, text] : header.texts) {
      if (name.starts_with(kOurs)) image.metadata[name.substr(kOurs.size())] = text;
    }
    image.data = input.read<float>(header.channels);
    return image;
  } catch (const std::bad_alloc&) {
    throw IoError("cannot read \"" + path + "\": the image does not fit into memory");
  } catch (const IoError& error) {
    throw IoError("cannot read \"" + path + "\": " + error.what());
  }
}

void check_image_extension(const std::string& path) {
  const std::string extension = file_extension(path);
  if (std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end()) return;
  throw UsageError(
      "\"" + path + "\": " +
      unknown_name_message("image format", extension,
                           std::vector<std::string>(kExtensions.begin(), kExtensions.end())));
}

bool is_display_file(const std::string& path) { return is_display_format(file_extension(path)); }

void write_image(const std::string& path, const Picture& picture) {
  check_image_extension(path);
  check_layers(picture);
  const std::string extension = file_extension(path);
  if (extension != ".exr" && picture.layers.front().channels != 3) {
    throw std::invalid_argument("write_image: only EXR holds layers of one channel");
  }
  const std::vector<unsigned char> bytes = encoded(path, picture);
  write_file_atomically(path, std::as_bytes(std::span(bytes)));
}

}  // namespace ajar
