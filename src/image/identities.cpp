#include "image/identities.h"

#include <algorithm>
#include <stdexcept>

namespace ajar {

namespace {

std::array<std::string, IdentityLayers::kSamples / 3> layer_names(const std::string& name) {
  return {name, name + ".1", name + ".2"};
}

/// The first sample of those that agree with most others. `agree(i, j)` is false for samples that
/// were not taken; sample 0 if none was.
template <typename Agree>
std::size_t majority(const Agree& agree) {
  std::size_t best = 0;
  std::size_t most = 0;
  for (std::size_t i = 0; i < IdentityLayers::kSamples; ++i) {
    std::size_t count = 0;
    for (std::size_t j = 0; j < IdentityLayers::kSamples; ++j) count += agree(i, j) ? 1 : 0;
    if (count > most) {
      most = count;
      best = i;
    }
  }
  return best;
}

}  // namespace

std::vector<LayerSpec> IdentityLayers::specs(const std::string& name) {
  std::vector<LayerSpec> specs;
  for (const std::string& layer : layer_names(name)) {
    specs.push_back({.name = layer,
                     .has_replicates = false,
                     .holds_identities = true,
                     .part_of = layer == name ? std::string() : name});
  }
  return specs;
}

IdentityLayers::IdentityLayers(const Film& film, const std::string& name) {
  const auto names = layer_names(name);
  std::transform(names.begin(), names.end(), layers_.begin(),
                 [&](const std::string& layer) { return film.layer(layer); });
}

void IdentityLayers::add(Film& film, Vec2i pixel, std::uint64_t sample,
                         std::uint32_t number) const {
  if (empty() || sample >= kSamples) return;
  // 0 is left for samples that were not taken.
  const float kept = static_cast<float>(number + 1);
  const std::uint64_t channel = sample % 3;
  film.add(
      layers_[sample / 3], 0, pixel,
      Spectrum(channel == 0 ? kept : 0.F, channel == 1 ? kept : 0.F, channel == 2 ? kept : 0.F));
}

std::vector<IdentityLayers::Votes> IdentityLayers::votes(const Film& film) const {
  std::vector<Votes> votes(static_cast<std::size_t>(film.width()) *
                           static_cast<std::size_t>(film.height()));
  for (std::size_t layer = 0; layer < kLayers; ++layer) {
    const std::vector<float> kept = film.develop(layers_[layer], 1.0);
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const std::size_t sample = 3 * layer + i % 3;
      // A film may come from a file, with sums that are no numbers of anything.
      const bool known = kept[i] >= 1.F && kept[i] < 0x1p32F;
      votes[i / 3].known[sample] = known;
      votes[i / 3].numbers[sample] = known ? static_cast<std::uint32_t>(kept[i]) - 1 : 0;
    }
  }
  return votes;
}

std::vector<float> majority_numbers(const Film& film, const std::string& name) {
  const IdentityLayers layers(film, name);
  if (layers.empty()) throw std::invalid_argument("identities: the film has no layer " + name);
  std::vector<float> numbers;
  for (const IdentityLayers::Votes& votes : layers.votes(film)) {
    const std::size_t sample = majority([&](std::size_t i, std::size_t j) {
      return votes.known[i] && votes.known[j] && votes.numbers[i] == votes.numbers[j];
    });
    numbers.push_back(static_cast<float>(votes.numbers[sample]));
  }
  return numbers;
}

std::vector<PixelIdentity> majority_identities(const Film& film) {
  const IdentityLayers object_layers(film, "object-id");
  const IdentityLayers material_layers(film, "material-id");
  if (object_layers.empty() || material_layers.empty()) {
    throw std::invalid_argument("identities: the film lacks object-id or material-id");
  }
  const auto objects = object_layers.votes(film);
  const auto materials = material_layers.votes(film);
  std::vector<PixelIdentity> identities;
  for (std::size_t pixel = 0; pixel < objects.size(); ++pixel) {
    const auto identity = [&](std::size_t i) {
      return PixelIdentity{objects[pixel].numbers[i], materials[pixel].numbers[i]};
    };
    const auto& known = objects[pixel].known;
    identities.push_back(identity(majority([&](std::size_t i, std::size_t j) {
      return known[i] && known[j] && identity(i) == identity(j);
    })));
  }
  return identities;
}

}  // namespace ajar
