#include "session/preview/tev_packets.h"

#include <bit>
#include <cstring>
#include <span>

namespace ajar {

namespace {

static_assert(std::endian::native == std::endian::little, "packets are little-endian");

constexpr std::uint8_t kCreateImage = 4;
constexpr std::uint8_t kUpdateImage = 6;  // the version with offsets and strides

class PacketWriter {
 public:
  PacketWriter(std::uint8_t type, bool grabs_focus) {
    put(std::uint32_t{0});  // the length, when it is known
    put(type);
    put(static_cast<std::uint8_t>(grabs_focus));
  }
  template <typename Number>
  void put(Number number) {
    char bytes[sizeof(Number)];
    std::memcpy(bytes, &number, sizeof(Number));
    bytes_.append(bytes, sizeof(Number));
  }
  void put_text(const std::string& text) { bytes_.append(text.c_str(), text.size() + 1); }
  void put_texts(const std::vector<std::string>& texts) {
    put(static_cast<std::int32_t>(texts.size()));
    for (const std::string& text : texts) put_text(text);
  }
  void put_floats(std::span<const float> values) {
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  }
  std::string finish() {
    const auto length = static_cast<std::uint32_t>(bytes_.size());
    std::memcpy(bytes_.data(), &length, sizeof(length));
    return std::move(bytes_);
  }

 private:
  std::string bytes_;
};

}  // namespace

std::vector<std::string> channel_names(const Picture& picture) {
  std::vector<std::string> names;
  for (const Picture::Layer& layer : picture.layers) {
    const std::string prefix = layer.name.empty() ? "" : layer.name + ".";
    if (layer.channels == 1) {
      names.push_back(layer.name);
      continue;
    }
    for (const char* channel : {"R", "G", "B"}) names.push_back(prefix + channel);
  }
  return names;
}

std::string create_image_packet(const std::string& name, Vec2i size,
                                const std::vector<std::string>& channels) {
  PacketWriter packet(kCreateImage, true);
  packet.put_text(name);
  packet.put(static_cast<std::int32_t>(size.x));
  packet.put(static_cast<std::int32_t>(size.y));
  packet.put_texts(channels);
  return packet.finish();
}

std::string update_image_packet(const std::string& name, const Picture& picture,
                                const Box2i& region) {
  const std::vector<std::string> channels = channel_names(picture);
  const Vec2i size = region.size() + Vec2i(1, 1);
  const auto pixels = static_cast<std::int64_t>(size.x) * size.y;
  PacketWriter packet(kUpdateImage, false);
  packet.put_text(name);
  packet.put_texts(channels);
  for (const int number : {region.min.x, region.min.y, size.x, size.y}) {
    packet.put(static_cast<std::int32_t>(number));
  }
  // One layer after the other, the channels of each interleaved, as they are here.
  std::int64_t layer_begin = 0;
  for (const Picture::Layer& layer : picture.layers) {
    for (int channel = 0; channel < layer.channels; ++channel) packet.put(layer_begin + channel);
    layer_begin += pixels * layer.channels;
  }
  for (const Picture::Layer& layer : picture.layers) {
    for (int channel = 0; channel < layer.channels; ++channel) {
      packet.put(static_cast<std::int64_t>(layer.channels));
    }
  }
  const auto width = static_cast<std::size_t>(picture.crop.size().x + 1);
  for (const Picture::Layer& layer : picture.layers) {
    const auto layer_channels = static_cast<std::size_t>(layer.channels);
    for (int y = region.min.y; y <= region.max.y; ++y) {
      const auto row = static_cast<std::size_t>(y - picture.crop.min.y);
      const auto column = static_cast<std::size_t>(region.min.x - picture.crop.min.x);
      const auto first = (row * width + column) * layer_channels;
      packet.put_floats(std::span(layer.pixels)
                            .subspan(first, static_cast<std::size_t>(size.x) * layer_channels));
    }
  }
  return packet.finish();
}

}  // namespace ajar
