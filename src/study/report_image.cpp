#include "study/report_image.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "imageio/image_file.h"

namespace ajar::study {

namespace {
template <std::size_t N>
bool is_one_of(const std::array<std::string_view, N>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool has_layer(const ReportImage& image, const std::string& name) {
  return std::any_of(image.layers.begin(), image.layers.end(),
                     [&](const ReportLayer& layer) { return layer.name == name; });
}

std::vector<float> one_channel(const Image& file, std::size_t channel) {
  const auto channels = static_cast<std::size_t>(file.channels);
  std::vector<float> values;
  values.reserve(file.data.size() / channels);
  for (std::size_t i = channel; i < file.data.size(); i += channels) values.push_back(file.data[i]);
  return values;
}

/// The layers beside the picture: colours where R, G and B are there, other channels by themselves.
void add_layers(const Image& file, ReportImage& image) {
  constexpr std::array<std::string_view, 4> kPicture{"R", "G", "B", "Y"};
  constexpr std::array<std::string_view, 3> kColours{"R", "G", "B"};
  for (std::size_t i = 0; i < file.names.size(); ++i) {
    const std::string& name = file.names[i];
    if (is_one_of(kPicture, name) || name.starts_with("replicates.")) continue;
    const std::size_t dot = name.rfind('.');
    if (dot != std::string::npos && is_one_of(kColours, std::string_view(name).substr(dot + 1))) {
      const std::string layer = name.substr(0, dot);
      if (has_layer(image, layer)) continue;
      if (std::vector<float> colours = file.rgb(layer); !colours.empty()) {
        image.layers.push_back({layer, 3, std::move(colours)});
        continue;
      }
    }
    image.layers.push_back({name, 1, one_channel(file, i)});
  }
}

/// "parameter:sampler" → "sampler", "render_seconds" → "render seconds".
std::string readable(std::string key) {
  constexpr std::string_view kParameter = "parameter:";
  if (key.starts_with(kParameter)) key.erase(0, kParameter.size());
  std::replace(key.begin(), key.end(), '_', ' ');
  return key;
}
}  // namespace

ReportImage report_image(const std::string& name, const LoadedPicture& picture) {
  ReportImage image{name, picture.size.x, picture.size.y, {}, {}, {}};
  image.layers.push_back({"", 3, picture.linear});
  image.metadata.emplace_back("file", picture.path);
  const Image file = read_image(picture.path);
  // The file may have been replaced meanwhile.
  const bool is_same = file.width == image.width && file.height == image.height;
  if (is_same && !picture.is_display_encoded) add_layers(file, image);
  for (const auto& [key, value] : file.metadata) image.metadata.emplace_back(readable(key), value);
  return image;
}

std::vector<ReportMetric> report_metrics(const std::vector<const Metric*>& metrics) {
  std::vector<ReportMetric> result;
  for (const Metric* metric : metrics) {
    const std::string unit = metric->unit.empty() ? "" : " [" + metric->unit + "]";
    result.push_back({metric->name, metric->summary + unit + ".", metric->larger_is_better});
  }
  return result;
}

}  // namespace ajar::study
