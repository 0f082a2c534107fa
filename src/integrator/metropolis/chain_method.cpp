#include "integrator/metropolis/chain_method.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "integrator/make_filter.h"
#include "integrator/metropolis/chain_film_sink.h"
#include "integrator/metropolis/heuristics.h"
#include "integrator/metropolis/path_seeds.h"
#include "integrator/montecarlo/blind_spots.h"
#include "integrator/montecarlo/path_family.h"
#include "integrator/montecarlo/path_parameters.h"

namespace ajar {

namespace {
/// pbrt's default, over all depths and replicates.
constexpr const char* kBootstrapSamples = "100000";
}  // namespace

ParameterSpec bootstrap_parameter() {
  return {.name = "bootstrap",
          .type = ParameterType::Int,
          .default_value = kBootstrapSamples,
          .unit = "samples",
          .help =
              "independent paths, over all depths and replicates, that say how bright "
              "the picture is and where chains start",
          .choices = {},
          .minimum = 1000,
          .maximum = 100000000};
}

ChainOrder chain_order(const RenderSettings& settings, const Parameters& parameters,
                       const std::map<std::string, std::string>& path_parameters) {
  Parameters monte_carlo(path_family_parameters(path_family_defaults("bdpt")), path_parameters);
  const Vec2i size = settings.crop.size() + Vec2i(1, 1);
  PathSamplerSettings sampler;
  sampler.techniques = techniques_of_chains(monte_carlo);
  sampler.heuristic = heuristic_of(monte_carlo);
  sampler.min_depth = settings.min_depth;
  sampler.max_depth = std::min(settings.max_depth, MetropolisHeuristics::kMostEdges);
  sampler.counted = settings.counted;
  sampler.light_paths_per_pixel =
      static_cast<double>(size.x) * size.y /
      (static_cast<double>(settings.resolution.x) * settings.resolution.y);
  return {.sampler = std::move(sampler),
          .groups = {},
          .bootstrap = static_cast<std::uint64_t>(parameters.get_int("bootstrap")),
          .monte_carlo = std::move(monte_carlo)};
}

ChainMethod::ChainMethod(const Scene& scene, const RenderSettings& settings, ChainOrder order)
    : scene_(scene),
      settings_(settings),
      view_(view_of(scene, settings)),
      order_(std::move(order)),
      concerns_(blind_spots(scene, settings, order_.sampler,
                            PathSeeds::any_has_manifolds(order_.groups))) {}

/// Without a bootstrap there is neither a seed nor b: ordinary Monte Carlo with the same techniques
/// makes the same picture.
void ChainMethod::skip_preparation(PreparationCut /*of*/) {
  RenderSettings own = settings_;
  own.max_depth = order_.sampler.max_depth;
  std::erase_if(own.aovs, is_chain_layer);
  unprepared_ = make_path_integrator(scene_, own, order_.monte_carlo);
}

Findings ChainMethod::findings() const {
  Findings found;
  if (unprepared_) {
    found = unprepared_->findings();
    found.notes = {
        "too little time to look for light that chains start from: rendered by plain Monte Carlo "
        "(" +
        order_.monte_carlo.get_text("techniques") + "); for chains, begin anew with more time"};
    return found;
  }
  found.concerns = concerns_;
  found.misses_light = misses_light_;
  if (has_chains()) {
    found.notes = {"Markov chains make all light"};
    found.notes.insert(found.notes.end(), order_.notes.begin(), order_.notes.end());
  }
  return found;
}

std::vector<LayerSpec> ChainMethod::layers() const {
  const double b = brightness();
  std::vector<LayerSpec> specs;
  if (unprepared_) {
    specs = unprepared_->layers();
  } else {
    specs = light_layers(std::isfinite(b) && b > 0.0 ? b : 1.0);
    if (settings_.for_filters) add_box_layers(specs, make_filter(scene_.film().filter));
  }
  add_chain_layers(specs, settings_.aovs);
  return specs;
}

DevelopScale ChainMethod::develop_scale(const LayerSpec& layer, std::uint64_t samples,
                                        std::optional<int> replicate) const {
  if (samples == 0) return 0.0;
  const double scale = 1.0 / static_cast<double>(samples);
  if (is_chain_layer(layer.name)) return scale;
  if (unprepared_) return unprepared_->develop_scale(layer, samples, replicate);
  return replicate ? scale * settings_.replicates : scale;
}

}  // namespace ajar
