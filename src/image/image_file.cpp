#include "image/image_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <memory>
#include <new>
#include <stdexcept>
#include <string_view>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/file_extension.h"
#include "core/image_input.h"
#include "image/pfm.h"

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

OIIO::ImageSpec make_spec(const Picture& picture, std::span<const Picture::Layer> layers,
                          const OIIO::TypeDesc& type) {
  OIIO::ImageSpec spec(picture.crop.max.x - picture.crop.min.x + 1,
                       picture.crop.max.y - picture.crop.min.y + 1, 0, type);
  spec.channelnames.clear();
  for (const Picture::Layer& layer : layers) {
    const std::string prefix = layer.name.empty() ? "" : layer.name + ".";
    if (layer.channels == 1) spec.channelnames.push_back(layer.name.empty() ? "Y" : layer.name);
    if (layer.channels == 3) {
      for (const char* channel : {"R", "G", "B"}) spec.channelnames.push_back(prefix + channel);
    }
  }
  spec.nchannels = static_cast<int>(spec.channelnames.size());
  for (const auto& [name, value] : picture.metadata) spec.attribute(name, value);
  return spec;
}

/// Encodes in memory, so that every failure of the disk is ours to see: most format libraries
/// ignore errors of the last flush. `row(y, out)` fills one interleaved row of floats.
template <typename T, typename Row>
std::vector<unsigned char> encode(const std::string& path, const OIIO::ImageSpec& spec, Row row) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const auto output = OIIO::ImageOutput::create("memory" + file_extension(path));
  const auto fail = [&]() {
    return IoError("cannot write \"" + path +
                   "\": " + (output ? output->geterror() : OIIO::geterror()));
  };
  if (!output || !output->supports("ioproxy") || !output->set_ioproxy(&memory)) throw fail();
  if (!output->open("memory" + file_extension(path), spec)) throw fail();
  constexpr int kRows = 64;
  const std::size_t stride =
      static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.nchannels);
  std::vector<T> strip(stride * kRows);
  const OIIO::TypeDesc type(OIIO::BaseTypeFromC<T>::value);
  for (int first = 0; first < spec.height; first += kRows) {
    const int count = std::min(kRows, spec.height - first);
    for (int i = 0; i < count; ++i)
      row(first + i, strip.data() + stride * static_cast<std::size_t>(i));
    if (!output->write_scanlines(spec.y + first, spec.y + first + count, 0, type, strip.data()))
      throw fail();
  }
  if (!output->close()) throw fail();
  return bytes;
}

std::vector<unsigned char> encode_exr(const std::string& path, const Picture& picture) {
  OIIO::ImageSpec spec = make_spec(picture, picture.layers, OIIO::TypeDesc::FLOAT);
  spec.x = picture.crop.min.x;
  spec.y = picture.crop.min.y;
  spec.full_x = 0;
  spec.full_y = 0;
  spec.full_width = picture.resolution.x;
  spec.full_height = picture.resolution.y;
  spec.attribute("compression", "zip");
  const auto width = static_cast<std::size_t>(spec.width);
  return encode<float>(path, spec, [&](int y, float* out) {
    std::size_t channel = 0;
    for (const Picture::Layer& layer : picture.layers) {
      const auto channels = static_cast<std::size_t>(layer.channels);
      const float* in = layer.pixels.data() + static_cast<std::size_t>(y) * width * channels;
      for (std::size_t x = 0; x < width; ++x) {
        std::copy_n(in + x * channels, channels,
                    out + x * static_cast<std::size_t>(spec.nchannels) + channel);
      }
      channel += channels;
    }
  });
}

std::vector<unsigned char> encode_hdr(const std::string& path, const Picture& picture) {
  OIIO::ImageSpec spec =
      make_spec(picture, std::span(picture.layers).first(1), OIIO::TypeDesc::FLOAT);
  const std::size_t row = static_cast<std::size_t>(spec.width) * 3;
  return encode<float>(path, spec, [&](int y, float* out) {
    const float* in = picture.layers[0].pixels.data() + static_cast<std::size_t>(y) * row;
    // Written so that NaN becomes zero.
    std::transform(in, in + row, out,
                   [](float v) { return v > 0.F ? std::min(v, kLargestHdr) : 0.F; });
  });
}

std::vector<unsigned char> encode_display(const std::string& path, const Picture& picture) {
  OIIO::ImageSpec spec =
      make_spec(picture, std::span(picture.layers).first(1), OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("CompressionQuality", 95);
  const std::size_t row = static_cast<std::size_t>(spec.width) * 3;
  return encode<unsigned char>(path, spec, [&](int y, unsigned char* out) {
    const float* in = picture.layers[0].pixels.data() + static_cast<std::size_t>(y) * row;
    // Written so that NaN becomes zero.
    std::transform(in, in + row, out, [](float v) {
      return static_cast<unsigned char>(v > 0.F ? std::lround(std::min(v, 1.F) * 255.F) : 0);
    });
  });
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
  for (const std::string& name : {layer, prefix + "Y", prefix + "Z"}) {
    if (const std::ptrdiff_t grey = find(name); grey >= 0) return gather(*this, {grey, grey, grey});
  }
  if (layer.empty() && channels == 1) return gather(*this, {0, 0, 0});
  return {};
}

Image read_image(const std::string& path) {
  if (file_extension(path) == ".pfm") return read_pfm(path);
  try {
    ImageInput input(path);
    const OIIO::ImageSpec& spec = input.spec();
    Image image;
    image.width = spec.width;
    image.height = spec.height;
    image.channels = spec.nchannels;
    image.names = spec.channelnames;
    image.origin = Vec2i(spec.x, spec.y) - Vec2i(spec.full_x, spec.full_y);
    image.resolution = {spec.full_width, spec.full_height};
    image.is_display_encoded = !spec.format.is_floating_point();
    constexpr std::string_view kOurs = "ajar:";
    for (const auto& attribute : spec.extra_attribs) {
      const std::string name = attribute.name().string();
      if (name.starts_with(kOurs))
        image.metadata[name.substr(kOurs.size())] = attribute.get_string();
    }
    image.data = input.read<float>(spec.nchannels);
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
  if (extension == ".pfm") {
    const Vec2i size = picture.crop.max - picture.crop.min + Vec2i(1, 1);
    write_file_atomically(path, encode_pfm(size.x, size.y, picture.layers.front().pixels));
    return;
  }
  const std::vector<unsigned char> bytes = extension == ".exr" ? encode_exr(path, picture)
                                           : is_display_format(extension)
                                               ? encode_display(path, picture)
                                               : encode_hdr(path, picture);
  write_file_atomically(path, std::as_bytes(std::span(bytes)));
}

}  // namespace ajar
