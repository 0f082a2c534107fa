#include "session/output/output.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "core/error.h"
#include "image/blur.h"
#include "image/identities.h"
#include "image/statistics.h"
#include "imageio/image_file.h"
#include "os/atomic_file.h"
#include "post/density_map.h"
#include "session/output/write_picture.h"

namespace ajar {

namespace {

namespace fs = std::filesystem;

int require_layer(const Film& film, const std::string& name) {
  const int layer = film.layer(name);
  if (layer < 0) throw std::invalid_argument("the film has no layer \"" + name + "\"");
  return layer;
}

std::vector<int> light_layers(const Film& film) {
  std::vector<int> layers = {require_layer(film, "direct"), require_layer(film, "indirect")};
  for (std::size_t i = 0; i < film.layers().size(); ++i) {
    const auto layer = static_cast<int>(i);
    if (film.layers()[i].is_light() && layer != layers[0] && layer != layers[1]) {
      layers.push_back(layer);
    }
  }
  return layers;
}

/// Light layers, those left out of which there is another estimate. None if there is none.
std::vector<int> other_light_layers(const Film& film) {
  std::vector<int> others;
  for (int layer : light_layers(film)) {
    const std::string& name = film.layers()[static_cast<std::size_t>(layer)].name;
    const auto other = std::find_if(film.layers().begin(), film.layers().end(),
                                    [&](const LayerSpec& spec) { return spec.instead_of == name; });
    if (other != film.layers().end()) {
      layer = static_cast<int>(std::distance(film.layers().begin(), other));
    }
    others.push_back(layer);
  }
  return others == light_layers(film) ? std::vector<int>() : others;
}

/// These layers and what makes boxes of their splats; none if all of them have boxes as they are.
std::vector<int> with_boxes(const Film& film, const std::vector<int>& layers) {
  std::vector<int> all = layers;
  for (std::size_t i = 0; i < film.layers().size(); ++i) {
    const std::string& base = film.layers()[i].box_of;
    const bool is_asked_for =
        !base.empty() && std::find(layers.begin(), layers.end(), film.layer(base)) != layers.end();
    if (is_asked_for) all.push_back(static_cast<int>(i));
  }
  return all.size() == layers.size() ? std::vector<int>() : all;
}

std::vector<ScaledLayer> scaled_layers(const std::vector<int>& chosen, const Development& scales,
                                       double film_scale) {
  std::vector<ScaledLayer> layers;
  for (const int layer : chosen) {
    ScaledLayer scaled{layer, {}};
    for (DevelopScale scale : scales.replicates[static_cast<std::size_t>(layer)]) {
      scale.factor *= film_scale;
      scaled.scales.push_back(std::move(scale));
    }
    layers.push_back(std::move(scaled));
  }
  return layers;
}

/// True if each replicate has samples, and there are several.
bool has_replicates(const Film& film, std::uint64_t samples) {
  return film.replicates() > 1 && samples >= static_cast<std::uint64_t>(film.replicates());
}

LayerValue value_of(const std::string& layer) {
  const AovInfo* const info = find_aov(layer);
  return info == nullptr ? LayerValue::Color : info->value;
}

Picture::Layer one_channel(const Picture::Layer& layer, LayerValue value) {
  Picture::Layer single{layer.name, 1, std::vector<float>(layer.pixels.size() / 3)};
  for (std::size_t i = 0; i < single.pixels.size(); ++i) {
    single.pixels[i] = layer.pixels[3 * i];
    const float events = layer.pixels[3 * i + 1];
    if (value == LayerValue::Mean) single.pixels[i] /= events > 0.F ? events : 1.F;
  }
  return single;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Adds what of the layers of surfaces is left when it is divided by how much of the pixel they
/// fill: `alpha` with what is in fog, `coverage` without. 0 where there is nothing.
void add_divided(Picture& picture, const Picture::Layer& alpha, const Picture::Layer& coverage) {
  const std::pair<const char*, const Picture::Layer*> parts[] = {{"albedo", &coverage},
                                                                 {"normal", &coverage},
                                                                 {"geometric-normal", &coverage},
                                                                 {"depth", &alpha},
                                                                 {"position", &alpha}};
  for (const auto& [name, share] : parts) {
    const auto whole =
        std::find_if(picture.layers.begin(), picture.layers.end(),
                     [&](const Picture::Layer& layer) { return layer.name == name; });
    if (whole == picture.layers.end()) continue;
    Picture::Layer divided{whole->name + ".divided", whole->channels, whole->pixels};
    const auto channels = static_cast<std::size_t>(divided.channels);
    for (std::size_t i = 0; i < divided.pixels.size(); ++i) {
      const float filled = share->pixels[i / channels];
      divided.pixels[i] = filled > 0.F ? divided.pixels[i] / filled : 0.F;
    }
    picture.layers.push_back(std::move(divided));
  }
}

/// Adds the pixels of a part to the layer it belongs to, which comes first.
void add_to_part(Picture& picture, const std::string& whole, const std::vector<float>& pixels) {
  const auto layer =
      std::find_if(picture.layers.begin(), picture.layers.end(),
                   [&](const Picture::Layer& candidate) { return candidate.name == whole; });
  std::transform(layer->pixels.begin(), layer->pixels.end(), pixels.begin(), layer->pixels.begin(),
                 std::plus<>());
}

/// Beside a picture for the eye, the layer "density" in false colours; empty without that layer.
std::optional<FinalFile> density_map_file(const Picture& picture, const std::string& path) {
  const auto layer =
      std::find_if(picture.layers.begin(), picture.layers.end(),
                   [](const Picture::Layer& candidate) { return candidate.name == "density"; });
  fs::path name(path);
  if (layer == picture.layers.end() || !is_display_file(path)) return std::nullopt;
  name.replace_extension(".density.png");
  DensityMap map = draw_density_map(layer->pixels, picture.crop.size() + Vec2i(1, 1));
  Picture colours;
  colours.resolution = map.size;
  colours.crop = Box2i(Vec2i(0, 0), map.size - Vec2i(1, 1));
  colours.layers.push_back({"", 3, std::move(map.rgb)});
  return FinalFile{
      "the density map", name.string(),
      [colours = std::move(colours)](const std::string& to) { write_picture(to, colours); }};
}

}  // namespace

Development development_of(const Film& film, const Integrator& integrator, std::uint64_t samples) {
  Development scales;
  for (const LayerSpec& layer : film.layers()) {
    const LayerSpec& spec = layer.box_of.empty()
                                ? layer
                                : film.layers()[static_cast<std::size_t>(film.layer(layer.box_of))];
    scales.whole.push_back(integrator.develop_scale(spec, samples, std::nullopt));
    std::vector<DevelopScale>& each = scales.replicates.emplace_back();
    for (int r = 0; spec.has_replicates && r < film.replicates(); ++r) {
      each.push_back(integrator.develop_scale(spec, samples, r));
    }
  }
  Findings found = integrator.findings();
  scales.maps = std::move(found.maps);
  scales.antialias_mask = std::move(found.antialias_mask);
  scales.misses_light = found.misses_light;
  return scales;
}

Development development_of_sum(const Development& a, const Development& b) {
  Development sum = a;
  sum.misses_light = a.misses_light || b.misses_light;
  for (std::size_t layer = 0; layer < sum.whole.size(); ++layer) {
    sum.whole[layer] = scale_of_sum(a.whole[layer], b.whole.at(layer));
    for (std::size_t r = 0; r < sum.replicates[layer].size(); ++r) {
      sum.replicates[layer][r] = scale_of_sum(a.replicates[layer][r], b.replicates.at(layer).at(r));
    }
  }
  return sum;
}

Picture develop(const Film& film, const Integrator& integrator, std::uint64_t samples,
                double film_scale, const std::vector<std::string>& aovs) {
  return develop(film, development_of(film, integrator, samples), samples, film_scale, aovs);
}

Picture develop(const Film& film, const Development& scales, std::uint64_t samples,
                double film_scale, const std::vector<std::string>& aovs) {
  Picture picture;
  picture.resolution = film.resolution();
  picture.crop = film.crop();
  picture.layers.push_back({"", 3, {}});
  Picture::Layer alpha;
  Picture::Layer coverage;
  for (std::size_t i = 0; i < film.layers().size(); ++i) {
    const LayerSpec& spec = film.layers()[i];
    if (!spec.instead_of.empty() || !spec.box_of.empty()) continue;
    if (spec.holds_identities) {
      if (spec.part_of.empty()) {
        picture.layers.push_back({spec.name, 1, majority_numbers(film, spec.name)});
      }
      continue;
    }
    DevelopScale scale = scales.whole[i];
    if (spec.is_light()) scale.factor *= film_scale;
    Picture::Layer layer{spec.name, 3, film.develop(static_cast<int>(i), scale)};
    if (!spec.part_of.empty()) {
      add_to_part(picture, spec.part_of, layer.pixels);
      continue;
    }
    const LayerValue value = value_of(spec.name);
    if (value != LayerValue::Color) layer = one_channel(layer, value);
    if (spec.name == "alpha") alpha = layer;
    if (spec.name == "coverage") coverage = layer;
    const bool divides =
        contains(aovs, "divided") && (spec.name == "alpha" || spec.name == "coverage");
    if (divides && !contains(aovs, spec.name)) continue;
    if (spec.name == "alpha") layer.name = kAlphaLayer;
    picture.layers.push_back(std::move(layer));
  }
  if (contains(aovs, "divided")) add_divided(picture, alpha, coverage);
  for (const auto& [name, plane] : scales.maps) picture.layers.push_back({name, 1, plane.values});
  picture.antialias_mask = scales.antialias_mask;
  // Sum of the displayed layers, equal to the picture to the bit.
  std::vector<float> sum;
  for (const Picture::Layer& layer : picture.layers) {
    if (layer.name != "direct" && layer.name != "indirect") continue;
    sum.resize(layer.pixels.size());
    std::transform(sum.begin(), sum.end(), layer.pixels.begin(), sum.begin(), std::plus<>());
  }
  for (const std::string& name : aovs) {
    if (name == "samples") {
      picture.layers.push_back(
          {name, 1, std::vector<float>(sum.size() / 3, static_cast<float>(samples))});
    } else if (name == "standard-error" && has_replicates(film, samples)) {
      const auto layers = scaled_layers(light_layers(film), scales, film_scale);
      picture.layers.push_back({name, 3, standard_error(develop_replicates(film, layers))});
    } else if (name == "standard-error-by-scale" && has_replicates(film, samples)) {
      const auto layers = scaled_layers(light_layers(film), scales, film_scale);
      const Replicates replicates = develop_replicates(film, layers);
      for (const double sigma : kErrorScales) {
        picture.layers.push_back(
            {fmt::format("standard-error.{:g}", sigma), 3,
             standard_error(blurred(replicates, Vec2i(film.width(), film.height()), sigma))});
      }
    } else if (name == "replicates") {
      const auto layers = scaled_layers(light_layers(film), scales, film_scale);
      int number = 0;
      for (std::vector<float>& replicate : develop_replicates(film, layers)) {
        picture.layers.push_back({fmt::format("{}.{}", name, number++), 3, std::move(replicate)});
      }
    }
  }
  for (std::size_t i = 0; i < film.layers().size(); ++i) {
    const int base = film.layer(film.layers()[i].box_of);
    if (base < 0 || !film.layers()[static_cast<std::size_t>(base)].is_light()) continue;
    if (picture.for_filters.empty()) picture.for_filters = sum;
    DevelopScale scale = scales.whole[i];
    scale.factor *= film_scale;
    const std::vector<float> boxes = film.develop(static_cast<int>(i), scale);
    std::transform(boxes.begin(), boxes.end(), picture.for_filters.begin(),
                   picture.for_filters.begin(), std::plus<>());
  }
  picture.layers.front().pixels = std::move(sum);
  return picture;
}

PictureEstimates estimates_of(const Film& film, const Development& scales, std::uint64_t samples,
                              double film_scale) {
  PictureEstimates estimates;
  estimates.samples = samples;
  if (!has_replicates(film, samples)) return estimates;
  estimates.replicates =
      develop_replicates(film, scaled_layers(light_layers(film), scales, film_scale));
  const auto developed = [&](const std::vector<int>& layers) {
    return develop_replicates(film, scaled_layers(layers, scales, film_scale));
  };
  const std::vector<int> boxes = with_boxes(film, light_layers(film));
  if (!boxes.empty()) estimates.boxes = developed(boxes);
  const std::vector<int> others = other_light_layers(film);
  if (!others.empty()) {
    const std::vector<int> other_boxes = with_boxes(film, others);
    estimates.others = developed(other_boxes.empty() ? others : other_boxes);
  }
  return estimates;
}

std::optional<RelativeError> estimate_error(const Film& film, const Integrator& integrator,
                                            std::uint64_t samples) {
  return estimate_error(film, development_of(film, integrator, samples), samples);
}

std::optional<RelativeError> estimate_error(const Film& film, const Development& scales,
                                            std::uint64_t samples) {
  if (!has_replicates(film, samples)) return std::nullopt;
  std::optional<RelativeError> error = estimate_relative_error(
      develop_replicates(film, scaled_layers(light_layers(film), scales, 1.0)),
      Vec2i(film.width(), film.height()));
  if (error) error->misses_light = scales.misses_light;
  return error;
}

std::vector<ErrorAtScale> estimate_errors_by_scale(const Film& film, const Development& scales,
                                                   std::uint64_t samples) {
  if (!has_replicates(film, samples)) return {};
  return estimate_errors_by_scale(
      develop_replicates(film, scaled_layers(light_layers(film), scales, 1.0)),
      Vec2i(film.width(), film.height()));
}

std::vector<std::string> default_outputs(const std::string& film_filename,
                                         const std::string& scene) {
  // Only the name: a scene of somebody else may name folders that do not exist here.
  std::string stem = fs::path(film_filename).stem().string();
  if (stem.empty()) stem = scene;
  return {stem + ".exr", stem + ".png"};
}

void check_writable(const std::string& path) {
  if (path.empty()) throw UsageError("a file name is empty");
  check_file_can_be_written(path);
  remove_abandoned_parts(path);
}

void check_picture_paths(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) check_image_extension(path);
  for (const std::string& path : paths) check_writable(path);
}

std::vector<FinalFile> picture_files(const Picture& picture, const std::vector<std::string>& paths,
                                     const DisplayOptions& display) {
  std::vector<FinalFile> files;
  files.reserve(paths.size());
  for (const std::string& path : paths) {
    files.push_back({"the picture", path, [&picture, display](const std::string& to) {
                       write_picture(to, picture, display);
                     }});
    std::optional<FinalFile> map = density_map_file(picture, path);
    if (map) files.push_back(std::move(*map));
  }
  return files;
}

}  // namespace ajar
