#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>

#include "core/error.h"
#include "core/image_encoder.h"

namespace ajar {

namespace {

OIIO::ImageSpec spec_of(const ImageLayout& layout, const OIIO::TypeDesc& type) {
  OIIO::ImageSpec spec(layout.width, layout.height, static_cast<int>(layout.names.size()), type);
  spec.channelnames = layout.names;
  for (const auto& [name, value] : layout.texts) spec.attribute(name, value);
  return spec;
}

/// `extension`: with its dot.
template <typename T>
std::vector<unsigned char> encode(const std::string& extension, const OIIO::ImageSpec& spec,
                                  const RowSource<T>& row) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const auto output = OIIO::ImageOutput::create("memory" + extension);
  const auto fail = [&] { return IoError(output ? output->geterror() : OIIO::geterror()); };
  if (!output || !output->supports("ioproxy") || !output->set_ioproxy(&memory)) throw fail();
  if (!output->open("memory" + extension, spec)) throw fail();
  constexpr int kRows = 64;
  const std::size_t stride =
      static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.nchannels);
  std::vector<T> strip(stride * kRows);
  const OIIO::TypeDesc type(OIIO::BaseTypeFromC<T>::value);
  for (int first = 0; first < spec.height; first += kRows) {
    const int count = std::min(kRows, spec.height - first);
    for (int i = 0; i < count; ++i) {
      row(first + i, strip.data() + stride * static_cast<std::size_t>(i));
    }
    if (!output->write_scanlines(spec.y + first, spec.y + first + count, 0, type, strip.data())) {
      throw fail();
    }
  }
  if (!output->close()) throw fail();
  return bytes;
}

OIIO::ImageSpec display_spec(const ImageLayout& layout) {
  OIIO::ImageSpec spec = spec_of(layout, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("CompressionQuality", 95);
  return spec;
}

}  // namespace

std::vector<unsigned char> encode_exr(const ImageLayout& layout, const RowSource<float>& row) {
  OIIO::ImageSpec spec = spec_of(layout, OIIO::TypeDesc::FLOAT);
  spec.x = layout.origin.x;
  spec.y = layout.origin.y;
  spec.full_x = 0;
  spec.full_y = 0;
  spec.full_width = layout.resolution.x;
  spec.full_height = layout.resolution.y;
  spec.attribute("compression", "zip");
  return encode<float>(".exr", spec, row);
}

std::vector<unsigned char> encode_hdr(const ImageLayout& layout, const RowSource<float>& row) {
  return encode<float>(".hdr", spec_of(layout, OIIO::TypeDesc::FLOAT), row);
}

std::vector<unsigned char> encode_png(const ImageLayout& layout,
                                      const RowSource<unsigned char>& row) {
  return encode<unsigned char>(".png", display_spec(layout), row);
}

std::vector<unsigned char> encode_jpeg(const ImageLayout& layout,
                                       const RowSource<unsigned char>& row) {
  return encode<unsigned char>(".jpg", display_spec(layout), row);
}

}  // namespace ajar
