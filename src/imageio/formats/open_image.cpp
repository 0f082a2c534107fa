#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>

#include "imageio/formats/image_formats.h"
#include "imageio/openimageio/openimageio_module.h"

namespace ajar {

namespace image_formats {

namespace {

struct Signature {
  std::string_view bytes;
  std::string_view format;
};
/// Of formats that others read, for the message.
constexpr std::array<Signature, 9> kOthers = {{{"II*", "a TIFF"},
                                               {"MM", "a TIFF"},
                                               {"GIF", "a GIF"},
                                               {"BM", "a BMP"},
                                               {"RIFF", "a WebP"},
                                               {"P6", "a PPM"},
                                               {"P5", "a PGM"},
                                               {"8BPS", "a PSD"},
                                               {"DDS ", "a DDS"}}};

std::string beginning_of(const std::string& path) {
  const File file = open_file(path);
  std::string bytes(16, '\0');
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file.get()));
  return bytes;
}

}  // namespace

File open_file(const std::string& path) {
  File file(std::fopen(path.c_str(), "rbe"));
  if (!file) throw IoError(std::generic_category().message(errno));
  return file;
}

std::unique_ptr<ImageDecoder> open_own(const std::string& path, bool has_unassociated_alpha) {
  const std::string bytes = beginning_of(path);
  if (bytes.starts_with("\x76\x2f\x31\x01")) return open_exr(path);
  if (bytes.starts_with("\x89PNG")) return open_png(path, has_unassociated_alpha);
  if (bytes.starts_with("\xff\xd8")) return open_jpeg(path);
  if (bytes.starts_with("#?")) return open_hdr(path);
  for (const Signature& other : kOthers) {
    if (bytes.starts_with(other.bytes)) throw ForeignImage(std::string(other.format));
  }
  throw ForeignImage("something unknown");
}

}  // namespace image_formats

std::unique_ptr<ImageDecoder> open_image(const std::string& path, bool has_unassociated_alpha) {
  try {
    return image_formats::open_own(path, has_unassociated_alpha);
  } catch (const image_formats::ForeignImage& image) {
    if (auto decoder = open_with_openimageio(path, has_unassociated_alpha)) return decoder;
    throw IoError(std::string("it is ") + image.what() +
                  ", which only builds of Ajar with OpenImageIO read; EXR, PNG, JPEG and HDR are "
                  "read by all");
  }
}

}  // namespace ajar
