#include "integrator/selective/preparation.h"

#include <stdexcept>

#include "integrator/montecarlo/path_family.h"

namespace ajar {

ChosenTechniques choose_techniques(const SelectiveConfig& config, const PathFamilyDefaults& omc) {
  const RenderSettings& settings = config.settings;
  PathSamplerSettings sampler;
  sampler.techniques = TechniqueSet::parse(omc.techniques);
  sampler.min_depth = std::max(settings.min_depth, Division::kDirectDepth + 1);
  sampler.max_depth = settings.max_depth;
  sampler.counted = settings.counted;
  sampler.light_subpaths = omc.light_paths_per_pixel;
  sampler.light_paths_per_pixel =
      sampler.light_subpaths * static_cast<double>(config.pixels()) /
      (static_cast<double>(settings.resolution.x) * settings.resolution.y);
  ChosenTechniques chosen{omc,
                          make_path_groups(config.scene, config.kind, sampler,
                                           path_family_defaults("bdpt").roulette_start),
                          {}};
  if (is_explicit(config.kind)) {
    chosen.depth_groups = make_path_groups(config.scene, ChainSpace::Mmlt, sampler, 0);
  }
  return chosen;
}

double effort_of(const PathFamilyDefaults& omc) {
  constexpr double kOfLight = SelectiveHeuristics::kEffortOfLight;
  const TechniqueSet set = TechniqueSet::parse(omc.techniques);
  const bool has_light = set.any(TechniqueClass::Light) || set.any(TechniqueClass::Inner);
  return (1.0 - kOfLight) + (has_light ? kOfLight * omc.light_paths_per_pixel : 0.0);
}

SelectivePreparation::SelectivePreparation(SelectiveConfig the_config)
    : config(std::move(the_config)),
      view(config.view),
      techniques(choose_techniques(config, config.omc)) {}

bool SelectivePreparation::has_efficient_roulette() const {
  if (config.roulette != kAuto) return config.roulette == "efficient";
  return !TechniqueSet::parse(techniques.omc.techniques).any(TechniqueClass::Inner);
}

const PathGroup& SelectivePreparation::group_of(int depth) const {
  const auto& own = is_explicit(config.kind) ? techniques.depth_groups : techniques.groups;
  const auto group = std::find_if(own.begin(), own.end(),
                                  [&](const PathGroup& one) { return one.depth == depth; });
  if (group == own.end()) throw std::logic_error("bug: no chains for paths of this depth");
  return *group;
}

const PathGroup& SelectivePreparation::group_of(const OutlierPath& found) const {
  const PathGroup& last = techniques.groups.back();
  if (is_explicit(last.kind) && has_paths(last.paths, found.unidirectional_only)) return last;
  return group_of(found.technique.depth());
}

PrimarySettings SelectivePreparation::moves_of(int replicate) const {
  constexpr double kRounding = 1.001;
  PrimarySettings own = config.moves;
  if (!is_explicit(config.kind) && divisions &&
      static_cast<double>(divisions->of(replicate).highest_threshold()) <=
          SelectiveHeuristics::kNearlyAllLight * kRounding * brightness) {
    own.probabilities.raster = SelectiveHeuristics::kRasterStepsOfAllLight;
  }
  return own;
}

std::size_t SelectivePreparation::chains_per_replicate() const {
  const auto replicates = static_cast<std::uint64_t>(config.settings.replicates);
  const auto steps = [&](double of_pixel) {
    return static_cast<std::uint64_t>(of_pixel * static_cast<double>(pixels())) / replicates;
  };
  const std::uint64_t expected = fireflies_only
                                     ? 0
                                     : std::min(steps(SelectiveHeuristics::kExpectedMutations) /
                                                    SelectiveHeuristics::kStepsOfChain,
                                                SelectiveHeuristics::kMostExpectedChains);
  return std::max<std::uint64_t>({1, steps(mutations) / SelectiveHeuristics::kStepsOfChain,
                                  expected,
                                  std::min(steps(mutations), SelectiveHeuristics::kFewestChains)});
}

std::unique_ptr<Integrator> SelectivePreparation::make_omc(const PathFamilyDefaults& omc,
                                                           RenderSettings settings,
                                                           PathIntegratorContext context) const {
  settings.min_depth = omc_depths().first;
  settings.max_depth = omc_depths().second;
  if (!context.scale) context.scale = scale;
  context.roulette = roulette.get();
  return make_path_integrator(config.scene, settings, omc_parameters(omc), context);
}

}  // namespace ajar
