#include "session/output/denoise_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.h"
#include "os/available_memory.h"
#include "session/output/picture_filter.h"

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

std::uint64_t denoising_bytes(const Picture& picture, const Denoiser& denoiser) {
  const std::size_t values = picture.layers.front().pixels.size();
  std::size_t replicates = 0;
  while (find_layer(picture, fmt::format("replicates.{}", replicates)) != nullptr) ++replicates;
  std::uint64_t filtering = 0;
  if (!PictureFilter::mixes(replicates)) {
    // Pictures that the filter reads and makes; features as they are, prepared and in the picture.
    const std::size_t pictures = replicates + 2 + (has_features(picture) ? 8 : 0);
    filtering = denoiser.memory_bytes(values / 3) + pictures * values * sizeof(float);
  } else {
    filtering =
        PictureFilter::memory_bytes(denoiser, values / 3) + replicates * values * sizeof(float);
  }
  // Afterwards the file, gathered and in its format.
  std::uint64_t writing = 0;
  for (const Picture::Layer& layer : picture.layers) {
    writing += 2 * layer.pixels.size() * sizeof(float);
  }
  return std::max(filtering, writing);
}

std::shared_ptr<const Denoiser> fitting_denoiser(const Picture& picture,
                                                 std::shared_ptr<const Denoiser> wanted,
                                                 bool may_be_another, std::uint64_t available,
                                                 std::string& note) {
  const std::uint64_t needed = denoising_bytes(picture, *wanted);
  if (fits_into_memory(needed, available)) return wanted;
  const std::string complaint =
      fmt::format("to denoise {}x{} pixels by {} needs {} of memory, and {} are free here",
                  picture.crop.size().x + 1, picture.crop.size().y + 1, wanted->name(),
                  bytes_text(needed), bytes_text(available));
  std::shared_ptr<const Denoiser> other = find_denoiser("builtin");
  const std::uint64_t least = denoising_bytes(picture, *other);
  if (!fits_into_memory(least, available)) throw UsageError(complaint);
  if (!may_be_another) {
    throw UsageError(complaint + "; --denoise builtin needs " + bytes_text(least));
  }
  note = complaint + ": the built-in filter takes its place, which leaves more noise";
  return other;
}

bool denoise_picture(Picture& picture, std::shared_ptr<const Denoiser> denoiser,
                     const Denoiser::Progress& progress) {
  PictureFilter filter(std::move(denoiser),
                       [features = features_in(picture)](
                           std::uint32_t /*rays*/, const Denoiser::Progress&) { return features; });
  const Replicates replicates = replicates_in(picture);
  std::erase_if(picture.layers, [](const Picture::Layer& layer) {
    return layer.name == kDenoisedLayer || layer.name == kDenoisedError ||
           layer.name == kFeatureAlbedo || layer.name == kFeatureNormal;
  });
  return filter.add_best_layers(picture, {replicates, {}}, progress);
}

}  // namespace ajar
