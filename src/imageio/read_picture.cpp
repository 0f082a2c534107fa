#include "imageio/read_picture.h"

#include <algorithm>
#include <set>

#include "core/error.h"
#include "imageio/image_file.h"
#include "os/available_memory.h"

namespace ajar {

namespace {

/// "albedo" of "albedo.R"; "" of "R".
std::string layer_of(const std::string& channel) {
  const std::size_t dot = channel.rfind('.');
  return dot == std::string::npos ? std::string() : channel.substr(0, dot);
}

bool has(const Image& image, const std::string& channel) {
  return std::find(image.names.begin(), image.names.end(), channel) != image.names.end();
}

std::vector<float> channel_of(const Image& image, std::size_t channel) {
  const auto channels = static_cast<std::size_t>(image.channels);
  std::vector<float> values(image.data.size() / channels);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = image.data[i * channels + channel];
  return values;
}

}  // namespace

Picture read_picture(const std::string& path) {
  const Image image = read_image(path);
  if (image.is_display_encoded) {
    throw IoError("cannot use \"" + path +
                  "\": it holds display values; scene-linear ones are needed");
  }
  // Its layers, beside it.
  if (const std::string preparation_cut = memory_shortage(image.data.size() * sizeof(float));
      !preparation_cut.empty()) {
    throw IoError("cannot use \"" + path + "\": the picture " + preparation_cut);
  }
  Picture picture;
  picture.resolution = image.resolution;
  picture.crop = Box2i(image.origin, image.origin + Vec2i(image.width - 1, image.height - 1));
  for (const auto& [name, value] : image.metadata) picture.metadata["ajar:" + name] = value;
  picture.layers.push_back({"", 3, image.rgb()});
  if (picture.layers.front().pixels.empty()) {
    throw IoError("cannot use \"" + path + "\": it has no channels R, G, B or Y");
  }
  std::set<std::string> done = {""};
  for (std::size_t i = 0; i < image.names.size(); ++i) {
    const std::string& channel = image.names[i];
    const std::string layer = layer_of(channel);
    const std::string before = layer.empty() ? "" : layer + ".";
    const std::string last = channel.substr(before.size());
    const bool is_colour = last == "R" || last == "G" || last == "B";
    if (is_colour && has(image, before + "R") && has(image, before + "G") &&
        has(image, before + "B")) {
      if (done.insert(layer).second) picture.layers.push_back({layer, 3, image.rgb(layer)});
    } else if (channel != "Y" && done.insert(channel).second) {
      picture.layers.push_back({channel, 1, channel_of(image, i)});
    }
  }
  return picture;
}

}  // namespace ajar
