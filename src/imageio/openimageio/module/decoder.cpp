#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "core/error.h"
#include "imageio/image_complaint.h"
#include "imageio/image_packing.h"
#include "imageio/openimageio/module/entry.h"

namespace ajar {

namespace {

/// Of EXR, exr_header.h knows more.
double packing_of(std::string_view format, std::string_view compression) {
  using namespace packing;
  if (format == "tiff") {
    if (compression == "none") return kUnpacked;
    if (compression == "packbits") return kRuns;
    if (compression == "zip") return kDeflate;
    return compression == "lzw" ? kLzw : kUnknown;
  }
  if (format == "bmp") return compression.empty() ? kUnpacked : kUnknown;
  struct Bound {
    std::string_view format;
    double pixels;
  };
  constexpr std::array<Bound, 13> kBounds = {{{"png", kDeflate},
                                              {"dds", kUnpacked},
                                              {"zfile", kDeflate},
                                              {"pnm", kUnpacked},
                                              {"cineon", kUnpacked},
                                              {"fits", kUnpacked},
                                              {"hdr", kRuns},
                                              {"dpx", kRuns},
                                              {"targa", kRuns},
                                              {"psd", kRuns},
                                              {"iff", kRuns},
                                              {"sgi", kRowTable},
                                              {"rla", kRowTable}}};
  const auto found = std::find_if(kBounds.begin(), kBounds.end(),
                                  [&](const Bound& bound) { return bound.format == format; });
  return found == kBounds.end() ? kUnknown : found->pixels;
}

SampleType sample_type(const OIIO::TypeDesc& type) {
  if (type.basetype == OIIO::TypeDesc::UINT8) return SampleType::UInt8;
  if (type.basetype == OIIO::TypeDesc::UINT16) return SampleType::UInt16;
  return type.basetype == OIIO::TypeDesc::HALF ? SampleType::Half : SampleType::Float;
}

OIIO::TypeDesc library_type(SampleType type) {
  switch (type) {
    case SampleType::UInt8:
      return OIIO::TypeDesc::UINT8;
    case SampleType::UInt16:
      return OIIO::TypeDesc::UINT16;
    case SampleType::Half:
      return OIIO::TypeDesc::HALF;
    case SampleType::Float:
      break;
  }
  return OIIO::TypeDesc::FLOAT;
}

class OpenImageIoDecoder final : public ImageDecoder {
 public:
  explicit OpenImageIoDecoder(std::unique_ptr<OIIO::ImageInput> input) : input_(std::move(input)) {
    if (spec().depth > 1) throw IoError("it is not a flat image with pixels");
    ImageHeader& to = header_;
    to.width = spec().width;
    to.height = spec().height;
    to.channels = spec().nchannels;
    to.names = spec().channelnames;
    to.alpha_channel = spec().alpha_channel;
    to.type = sample_type(spec().format);
    to.is_integer = !spec().format.is_floating_point();
    to.origin = Vec2i(spec().x, spec().y) - Vec2i(spec().full_x, spec().full_y);
    to.resolution = {spec().full_width, spec().full_height};
    for (const auto& attribute : spec().extra_attribs) {
      if (attribute.type() == OIIO::TypeString) {
        to.texts[attribute.name().string()] = attribute.get_string();
      }
    }
  }

  double most_pixels_per_byte() const override {
    return packing_of(input_->format_name(), spec().get_string_attribute("compression"));
  }
  std::uint64_t pixel_bytes() const override { return spec().pixel_bytes(true); }

  bool is_read_in_parts() const override {
    constexpr std::array<std::string_view, 8> kFormats = {"openexr", "tiff", "jpeg",   "hdr",
                                                          "pnm",     "dpx",  "cineon", "fits"};
    const std::string_view format = input_->format_name();
    if (format == "png") return spec().get_int_attribute("png:interlaced") == 0;
    return std::find(kFormats.begin(), kFormats.end(), format) != kFormats.end();
  }

  std::uint64_t working_bytes() const override {
    // Of rows it takes so many at a time, even if the image has fewer.
    constexpr std::uint64_t kRows = 256;
    if (spec().tile_width == 0) return kRows * spec().scanline_bytes(true);
    const auto tiles = static_cast<std::uint64_t>(
        (static_cast<std::int64_t>(spec().width) + spec().tile_width - 1) / spec().tile_width);
    return (tiles + 1) * spec().tile_bytes(true);
  }

  int block_height() const override {
    return spec().tile_width > 0 ? std::max(spec().tile_height, 1) : 64;
  }

  void read_rows(int first, int rows, int first_channel, int channels, SampleType type,
                 void* values) override {
    const int end = first_channel + channels;
    const int y = spec().y + first;
    const bool is_read =
        spec().tile_width == 0
            ? input_->read_scanlines(0, 0, y, y + rows, spec().z, first_channel, end,
                                     library_type(type), values)
            : input_->read_tiles(0, 0, spec().x, spec().x + spec().width, y, y + rows, spec().z,
                                 spec().z + 1, first_channel, end, library_type(type), values);
    if (!is_read) throw IoError(image_complaint(input_->geterror()));
  }

 private:
  const OIIO::ImageSpec& spec() const { return input_->spec(); }

  std::unique_ptr<OIIO::ImageInput> input_;
};

}  // namespace

}  // namespace ajar

ajar::ImageDecoder* ajar_open_image_by_openimageio(const char* path, bool has_unassociated_alpha) {
  OIIO::ImageSpec config;
  if (has_unassociated_alpha) config.attribute("oiio:UnassociatedAlpha", 1);
  auto input = OIIO::ImageInput::open(path, &config);
  if (!input) throw ajar::IoError(ajar::image_complaint(OIIO::geterror()));
  return std::make_unique<ajar::OpenImageIoDecoder>(std::move(input)).release();
}
