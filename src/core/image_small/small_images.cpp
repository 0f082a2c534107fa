#include "core/image_small/small_images.h"

#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>

#include "core/error.h"

namespace ajar::small_images {

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

std::unique_ptr<ImageDecoder> open_image(const std::string& path, bool has_unassociated_alpha) {
  const std::string bytes = beginning_of(path);
  if (bytes.starts_with("\x76\x2f\x31\x01")) return open_exr(path);
  if (bytes.starts_with("\x89PNG")) return open_png(path, has_unassociated_alpha);
  if (bytes.starts_with("\xff\xd8")) return open_jpeg(path);
  if (bytes.starts_with("#?")) return open_hdr(path);
  std::string what = "it is none of the images that this build of Ajar reads (EXR, PNG, JPEG, HDR)";
  for (const Signature& other : kOthers) {
    if (bytes.starts_with(other.bytes)) what += ", but " + std::string(other.format);
  }
  throw IoError(what + "; a build with OpenImageIO reads more");
}

}  // namespace ajar::small_images
