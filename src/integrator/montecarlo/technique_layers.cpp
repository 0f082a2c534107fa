#include "integrator/montecarlo/technique_layers.h"

#include <algorithm>

namespace ajar {

namespace {
std::string layer_name(const char* kind, Technique technique) {
  return TechniqueLayers::aov_name() + "." + kind + ".s" + std::to_string(technique.s) + "t" +
         std::to_string(technique.t);
}

/// Calls `use` with every technique there can be up to the depth of the pyramid.
template <typename Use>
void for_each_technique(const Use& use) {
  for (int depth = 1; depth <= TechniqueLayers::kMaxDepth; ++depth) {
    for (int s = 0; s <= depth; ++s) use(Technique{s, depth + 1 - s});
  }
}
}  // namespace

const std::string& TechniqueLayers::aov_name() {
  static const std::string kName = "techniques";
  return kName;
}

std::vector<LayerSpec> TechniqueLayers::specs(const PathSamplerSettings& settings,
                                              double magnitude) {
  std::vector<LayerSpec> specs;
  for_each_technique([&](Technique technique) {
    const int depth = technique.depth();
    if (depth < settings.min_depth || depth > settings.max_depth) return;
    if (!settings.techniques.enabled(technique)) return;
    for (const char* kind : {"weighted", "unweighted"}) {
      specs.push_back(
          {.name = layer_name(kind, technique), .has_replicates = false, .magnitude = magnitude});
    }
  });
  return specs;
}

std::size_t TechniqueLayers::slot(Technique technique) {
  return static_cast<std::size_t>(technique.s) * (kMaxDepth + 2) +
         static_cast<std::size_t>(technique.t);
}

TechniqueLayers::TechniqueLayers(const Film& film) {
  const auto layers = film.layers();
  const bool wanted = std::any_of(layers.begin(), layers.end(), [](const LayerSpec& layer) {
    return layer.name.starts_with(aov_name());
  });
  if (!wanted) return;
  for_each_technique([&](Technique technique) {
    const Pair pair{film.layer(layer_name("weighted", technique)),
                    film.layer(layer_name("unweighted", technique))};
    if (pair.weighted < 0) return;
    layers_.resize(slot({kMaxDepth + 1, kMaxDepth + 1}) + 1);
    layers_[slot(technique)] = pair;
  });
}

bool TechniqueLayers::add(Film& film, Vec2i pixel, float weight,
                          const Contribution& contribution) const {
  if (contribution.technique.depth() > kMaxDepth) return true;
  const Pair& pair = layers_[slot(contribution.technique)];
  const Spectrum alone = contribution.value / static_cast<float>(contribution.mis_weight);
  if (contribution.technique.t == 1) {
    return film.splat(pair.weighted, 0, contribution.raster, contribution.value) &&
           film.splat(pair.unweighted, 0, contribution.raster, alone);
  }
  return film.add(pair.weighted, 0, pixel, contribution.value * weight) &&
         film.add(pair.unweighted, 0, pixel, alone * weight);
}

}  // namespace ajar
