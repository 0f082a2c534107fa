#include "integrator/metropolis/chain_film_sink.h"

#include <algorithm>

namespace ajar {

RenderSettings beside_chains(RenderSettings settings) {
  std::erase_if(settings.aovs, [](const std::string& name) {
    return is_chain_layer(name) || name == "techniques";
  });
  return settings;
}

void add_chain_layers(std::vector<LayerSpec>& specs, const std::vector<std::string>& aovs) {
  for (const std::string& name : {kDensityLayer, kAcceptanceLayer}) {
    if (std::find(aovs.begin(), aovs.end(), name) != aovs.end()) {
      specs.push_back({.name = name, .has_replicates = false});
    }
  }
}

ChainFilmSink::ChainFilmSink(Film& film, int replicate, const ImportanceMap& importance,
                             const PathTarget* target, Counters& counters, VisitSink* visits,
                             const ChainWeight* part)
    : film_(film),
      light_{film.layer("direct"), film.layer("indirect")},
      density_(film.layer(kDensityLayer)),
      acceptance_(film.layer(kAcceptanceLayer)),
      replicate_(replicate),
      importance_(importance),
      target_(target),
      counters_(counters),
      visits_(visits),
      part_(part) {}

void ChainFilmSink::deposit(std::span<const Splat> splats, double factor) {
  for (const Splat& splat : splats) {
    const int layer = light_[static_cast<std::size_t>(splat.layer)];
    Spectrum value = splat.value * static_cast<float>(factor * scale_);
    if (part_ != nullptr && splat.layer == kIndirectSplat)
      value *= part_->deposit_scale(splat.raster);
    if (!film_.splat(layer, replicate_, splat.raster, value)) ++counters_.discarded_infinite;
    if (density_ < 0 && visits_ == nullptr) continue;
    const double share = factor * static_cast<double>(luminance(splat.value)) *
                         static_cast<double>(importance_(splat.raster));
    if (density_ >= 0) {
      film_.splat(density_, 0, splat.raster, Spectrum(static_cast<float>(share)));
    }
    if (visits_ != nullptr) {
      visits_->add(replicate_, splat.raster, share, static_cast<double>(luminance(value)));
    }
  }
}

void ChainFilmSink::proposed(std::span<const Splat> current, double acceptance) {
  if (by_technique_ != nullptr && target_ != nullptr && target_->technique() != nullptr) {
    auto& kind = (*by_technique_)[target_->technique()->number];
    ++kind.proposals;
    kind.acceptances += acceptance;
  }
  if (acceptance_ >= 0 && !current.empty()) {
    film_.splat(acceptance_, 0, current.front().raster,
                Spectrum(static_cast<float>(acceptance), 1.F, 0.F));
  }
}

}  // namespace ajar
