#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfTileDescriptionAttribute.h>

#include <algorithm>
#include <string_view>
#include <tuple>

#include "core/error.h"
#include "core/image_formats/image_formats.h"
#include "core/image_packing.h"

namespace ajar::image_formats {

namespace {

/// The order of channels: layer by layer, colours as people say them.
std::tuple<std::string_view, std::size_t, std::string_view> rank_of(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  const std::size_t start = dot == std::string::npos ? 0 : dot + 1;
  const std::string_view text = name;
  const std::string_view last = text.substr(start);
  constexpr std::string_view kColors = "RGBA";
  const std::size_t color = last.size() == 1 ? kColors.find(last) : std::string_view::npos;
  return {text.substr(0, start), std::min(color, kColors.size()), last};
}

/// Whether red, green, blue and white are about those that are meant where a file says nothing.
bool is_rec709(const Imf::Chromaticities& given) {
  constexpr float kNear = 2e-3F;
  const Imf::Chromaticities usual;
  return (given.red - usual.red).length() < kNear && (given.green - usual.green).length() < kNear &&
         (given.blue - usual.blue).length() < kNear && (given.white - usual.white).length() < kNear;
}

class ExrDecoder final : public ImageDecoder {
 public:
  explicit ExrDecoder(const std::string& path) : file_(path.c_str(), 0) {
    const Imf::Header& from = file_.header();
    const Imath::Box2i data = from.dataWindow();
    const Imath::Box2i display = from.displayWindow();
    ImageHeader& to = header_;
    to.width = data.max.x - data.min.x + 1;
    to.height = data.max.y - data.min.y + 1;
    to.origin = data.min - display.min;
    to.resolution = display.max - display.min + Vec2i(1, 1);
    to.type = SampleType::Half;
    for (auto channel = from.channels().begin(); channel != from.channels().end(); ++channel) {
      to.names.emplace_back(channel.name());
      if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1) {
        throw ForeignImage("an EXR with subsampled channels");
      }
      if (channel.channel().type != Imf::HALF) to.type = SampleType::Float;
    }
    std::sort(to.names.begin(), to.names.end(),
              [](const std::string& a, const std::string& b) { return rank_of(a) < rank_of(b); });
    to.channels = static_cast<int>(to.names.size());
    const auto alpha = std::find(to.names.begin(), to.names.end(), "A");
    if (alpha != to.names.end()) to.alpha_channel = static_cast<int>(alpha - to.names.begin());
    if (Imf::hasChromaticities(from))
      to.has_other_primaries = !is_rec709(Imf::chromaticities(from));
    for (auto attribute = from.begin(); attribute != from.end(); ++attribute) {
      const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute());
      if (text != nullptr) to.texts[attribute.name()] = text->value();
    }
  }

  /// exr_header.h knows more.
  double most_pixels_per_byte() const override { return packing::kUnknown; }
  std::uint64_t pixel_bytes() const override {
    return header().names.size() * size_of(header().type);
  }
  bool is_read_in_parts() const override { return true; }
  std::uint64_t working_bytes() const override {
    return static_cast<std::uint64_t>(std::max(block_height(), 256)) *
           static_cast<std::uint64_t>(header().width) * pixel_bytes();
  }
  int block_height() const override {
    const Imf::Header& from = file_.header();
    return from.hasTileDescription()
               ? static_cast<int>(std::clamp(from.tileDescription().ySize, 1U, 65536U))
               : 64;
  }

  void read_rows(int first, int rows, int first_channel, int channels, SampleType type,
                 void* values) override {
    const Imath::Box2i data = file_.header().dataWindow();
    const int y = data.min.y + first;
    const std::size_t size = size_of(type);
    const std::size_t pixel = size * static_cast<std::size_t>(channels);
    const std::size_t row = pixel * static_cast<std::size_t>(header().width);
    Imf::FrameBuffer buffer;
    for (int i = 0; i < channels; ++i) {
      char* base = static_cast<char*>(values) + static_cast<std::size_t>(i) * size;
      buffer.insert(header().names[static_cast<std::size_t>(first_channel + i)],
                    Imf::Slice::Make(type == SampleType::Half ? Imf::HALF : Imf::FLOAT, base,
                                     Imath::V2i(data.min.x, y), header().width, rows, pixel, row));
    }
    file_.setFrameBuffer(buffer);
    file_.readPixels(y, y + rows - 1);
  }

 private:
  Imf::InputFile file_;
};

}  // namespace

std::unique_ptr<ImageDecoder> open_exr(const std::string& path) {
  return std::make_unique<ExrDecoder>(path);
}

}  // namespace ajar::image_formats
