#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfTileDescriptionAttribute.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "core/error.h"
#include "imageio/color_channels.h"
#include "imageio/formats/image_formats.h"
#include "imageio/image_packing.h"

namespace ajar::image_formats {

namespace {

/// True if red, green, blue and white are about the defaults of files without them.
bool is_rec709(const Imf::Chromaticities& given) {
  constexpr float kNear = 2e-3F;
  const Imf::Chromaticities usual;
  return (given.red - usual.red).length() < kNear && (given.green - usual.green).length() < kNear &&
         (given.blue - usual.blue).length() < kNear && (given.white - usual.white).length() < kNear;
}

std::string part_name(const Imf::Header& part) { return part.hasName() ? part.name() : ""; }

/// Channels with a value for every pixel.
std::vector<std::string> full_channels(const Imf::Header& part) {
  std::vector<std::string> names;
  for (auto channel = part.channels().begin(); channel != part.channels().end(); ++channel) {
    if (channel.channel().xSampling == 1 && channel.channel().ySampling == 1) {
      names.emplace_back(channel.name());
    }
  }
  std::sort(names.begin(), names.end(), comes_before);
  return names;
}

/// Luminance and two differences of colour, which mostly have a quarter of the pixels each.
bool has_luminance_and_chroma(const Imf::Header& part) {
  const Imf::ChannelList& all = part.channels();
  return all.findChannel("Y") != nullptr && all.findChannel("RY") != nullptr &&
         all.findChannel("BY") != nullptr;
}

/// The part that is the picture: the order of parts says nothing.
int part_of_picture(const Imf::MultiPartInputFile& file) {
  const auto doubt = [&](int i) {
    const Imf::Header& part = file.header(i);
    const std::vector<std::string> names = full_channels(part);
    return std::tuple(names.empty(), color_channels(names).doubt,
                      !is_whole_picture(part_name(part)));
  };
  int best = 0;
  for (int i = 1; i < file.parts(); ++i) {
    if (doubt(i) < doubt(best)) best = i;
  }
  return best;
}

/// Fills in all of a header but the channels.
void describe(const Imf::Header& from, ImageHeader& to) {
  const Imath::Box2i data = from.dataWindow();
  const Imath::Box2i display = from.displayWindow();
  to.width = data.max.x - data.min.x + 1;
  to.height = data.max.y - data.min.y + 1;
  to.origin = data.min - display.min;
  to.resolution = display.max - display.min + Vec2i(1, 1);
  to.type = SampleType::Half;
  if (Imf::hasChromaticities(from)) to.has_other_primaries = !is_rec709(Imf::chromaticities(from));
  for (auto attribute = from.begin(); attribute != from.end(); ++attribute) {
    const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute());
    if (text != nullptr) to.texts[attribute.name()] = text->value();
  }
}

int rows_of_block(const Imf::Header& part) {
  return part.hasTileDescription()
             ? static_cast<int>(std::clamp(part.tileDescription().ySize, 1U, 65536U))
             : 64;
}

/// The parts of a file that have the pixels of the picture, as layers.
class ExrDecoder final : public ImageDecoder {
 public:
  ExrDecoder(std::unique_ptr<Imf::MultiPartInputFile> file, int picture)
      : file_(std::move(file)), picture_(picture) {
    describe(from(), header_);
    add_part(picture_);
    for (int i = 0; i < file_->parts(); ++i) {
      if (i != picture_ && file_->header(i).dataWindow() == from().dataWindow()) add_part(i);
    }
    for (const auto& [name, place] : places_) header_.names.push_back(name);
    std::sort(header_.names.begin(), header_.names.end(), comes_before);
    header_.channels = static_cast<int>(header_.names.size());
    const auto alpha = std::find(header_.names.begin(), header_.names.end(), "A");
    if (alpha != header_.names.end()) {
      header_.alpha_channel = static_cast<int>(alpha - header_.names.begin());
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
  int block_height() const override { return rows_of_block(from()); }

  void read_rows(int first, int rows, int first_channel, int channels, SampleType type,
                 void* values) override {
    const Imath::Box2i data = from().dataWindow();
    const int y = data.min.y + first;
    const std::size_t size = size_of(type);
    const std::size_t pixel = size * static_cast<std::size_t>(channels);
    const std::size_t row = pixel * static_cast<std::size_t>(header().width);
    std::map<int, Imf::FrameBuffer> buffers;  // buffers of parts
    for (int i = 0; i < channels; ++i) {
      char* base = static_cast<char*>(values) + static_cast<std::size_t>(i) * size;
      const Place& place = places_.at(header().names[static_cast<std::size_t>(first_channel + i)]);
      buffers[place.part].insert(
          place.channel,
          Imf::Slice::Make(type == SampleType::Half ? Imf::HALF : Imf::FLOAT, base,
                           Imath::V2i(data.min.x, y), header().width, rows, pixel, row));
    }
    for (const auto& [number, buffer] : buffers) {
      Imf::InputPart part(*file_, number);
      part.setFrameBuffer(buffer);
      part.readPixels(y, y + rows - 1);
    }
  }

 private:
  struct Place {
    int part;
    std::string channel;
  };

  const Imf::Header& from() const { return file_->header(picture_); }

  /// Channels of the picture keep their names; "R" of another part belongs to a layer.
  void add_part(int number) {
    const Imf::Header& part = file_->header(number);
    for (const std::string& channel : full_channels(part)) {
      const bool is_layer = number != picture_ && prefix_of_channel(channel).empty();
      std::string name = is_layer ? part_name(part) + "." + channel : channel;
      if (!places_.try_emplace(std::move(name), Place{number, channel}).second) continue;
      if (part.channels()[channel].type != Imf::HALF) header_.type = SampleType::Float;
    }
  }

  std::unique_ptr<Imf::MultiPartInputFile> file_;
  int picture_;
  std::map<std::string, Place> places_;  ///< places of channels
};

/// Red, green and blue of luminance and chroma, by the library's own filters.
class LuminanceChromaDecoder final : public ImageDecoder {
 public:
  explicit LuminanceChromaDecoder(const std::string& path) : file_(path.c_str(), 0) {
    describe(file_.header(), header_);
    header_.names = {"R", "G", "B"};
    if ((file_.channels() & Imf::WRITE_A) != 0) {
      header_.alpha_channel = 3;
      header_.names.emplace_back("A");
    }
    header_.channels = static_cast<int>(header_.names.size());
  }

  double most_pixels_per_byte() const override { return packing::kUnknown; }
  std::uint64_t pixel_bytes() const override { return sizeof(Imf::Rgba); }
  bool is_read_in_parts() const override { return true; }
  std::uint64_t working_bytes() const override {
    constexpr std::uint64_t kRows = 256;
    return kRows * static_cast<std::uint64_t>(header().width) * pixel_bytes();
  }
  int block_height() const override { return rows_of_block(file_.header()); }

  void read_rows(int first, int rows, int first_channel, int channels, SampleType type,
                 void* values) override {
    const Imath::Box2i data = file_.dataWindow();
    const auto width = static_cast<std::size_t>(header().width);
    std::vector<Imf::Rgba> row(width);
    void* to = values;
    for (int y = data.min.y + first; y < data.min.y + first + rows; ++y) {
      file_.setFrameBuffer(row.data() - data.min.x, 1, 0);
      file_.readPixels(y);
      if (type == SampleType::Half) {
        to = copy(row, first_channel, channels, static_cast<Imath::half*>(to));
      } else {
        to = copy(row, first_channel, channels, static_cast<float*>(to));
      }
    }
  }

 private:
  template <typename T>
  static T* copy(const std::vector<Imf::Rgba>& row, int first_channel, int channels, T* to) {
    for (const Imf::Rgba& pixel : row) {
      const Imath::half all[4] = {pixel.r, pixel.g, pixel.b, pixel.a};
      for (int c = 0; c < channels; ++c) *to++ = all[first_channel + c];
    }
    return to;
  }

  Imf::RgbaInputFile file_;
};

}  // namespace

std::unique_ptr<ImageDecoder> open_exr(const std::string& path) {
  auto file = std::make_unique<Imf::MultiPartInputFile>(path.c_str(), 0);
  const int picture = part_of_picture(*file);
  if (has_luminance_and_chroma(file->header(picture))) {
    if (picture == 0) return std::make_unique<LuminanceChromaDecoder>(path);
    throw IoError("it has luminance and chroma in a part that is not the first");
  }
  if (full_channels(file->header(picture)).empty()) {
    throw ForeignImage("an EXR with subsampled channels");
  }
  return std::make_unique<ExrDecoder>(std::move(file), picture);
}

}  // namespace ajar::image_formats
