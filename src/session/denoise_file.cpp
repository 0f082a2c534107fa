#include "session/denoise_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "session/picture_filter.h"

namespace ajar {

namespace {

/// Null if there is none of three channels.
const std::vector<float>* find_layer(const Picture& picture, const std::string& name) {
  const auto found = std::find_if(
      picture.layers.begin(), picture.layers.end(),
      [&](const Picture::Layer& layer) { return layer.name == name && layer.channels == 3; });
  return found == picture.layers.end() ? nullptr : &found->pixels;
}

Features features_in(const Picture& picture) {
  for (const auto& [albedo_name, normal_name] :
       {std::pair(kFeatureAlbedo, kFeatureNormal), std::pair("albedo", "normal")}) {
    const std::vector<float>* albedo = find_layer(picture, albedo_name);
    const std::vector<float>* normal = find_layer(picture, normal_name);
    if (albedo != nullptr && normal != nullptr) return {*albedo, *normal};
  }
  return {};
}

Replicates replicates_in(const Picture& picture) {
  Replicates replicates;
  while (const auto* next = find_layer(picture, fmt::format("replicates.{}", replicates.size()))) {
    replicates.push_back(*next);
  }
  return replicates;
}

}  // namespace

bool has_features(const Picture& picture) { return !features_in(picture).empty(); }

bool denoise_picture(Picture& picture, std::shared_ptr<const Denoiser> denoiser,
                     const Denoiser::Progress& progress) {
  PictureFilter filter(std::move(denoiser), [features = features_in(picture)](
                                                const Denoiser::Progress&) { return features; });
  const Replicates replicates = replicates_in(picture);
  std::erase_if(picture.layers, [](const Picture::Layer& layer) {
    return layer.name == kDenoisedLayer || layer.name == kDenoisedError ||
           layer.name == kFeatureAlbedo || layer.name == kFeatureNormal;
  });
  return filter.add_best_layers(picture, {replicates, {}}, progress);
}

}  // namespace ajar
