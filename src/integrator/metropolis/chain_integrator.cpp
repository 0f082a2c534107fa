#include "integrator/metropolis/chain_integrator.h"

namespace ajar {

namespace {
/// As pbrt has them, over all depths and replicates.
constexpr const char* kBootstrapSamples = "100000";
constexpr const char* kChains = "1000";
}  // namespace

void add_chain_counts(std::vector<ParameterSpec>& specs) {
  specs.push_back({.name = "bootstrap",
                   .type = ParameterType::Int,
                   .default_value = kBootstrapSamples,
                   .unit = "samples",
                   .help = "independent paths, over all depths and replicates, that say how bright "
                           "the picture is and where chains start",
                   .choices = {},
                   .minimum = 1000,
                   .maximum = 100000000});
  specs.push_back({.name = "chains",
                   .type = ParameterType::Int,
                   .default_value = kChains,
                   .unit = "",
                   .help = "number of Markov chains",
                   .choices = {},
                   .minimum = 1,
                   .maximum = 1000000});
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
  sampler.light_paths_per_pixel =
      static_cast<double>(size.x) * size.y /
      (static_cast<double>(settings.resolution.x) * settings.resolution.y);
  return {.sampler = std::move(sampler),
          .groups = {},
          .bootstrap = static_cast<std::uint64_t>(parameters.get_int("bootstrap")),
          .chains = static_cast<std::size_t>(parameters.get_int("chains")),
          .monte_carlo = std::move(monte_carlo)};
}

}  // namespace ajar
