#include "integrator/selective/chain_plan.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string_view>

#include "integrator/metropolis/chain_film_sink.h"
#include "integrator/metropolis/heuristics.h"
#include "integrator/metropolis/path_space.h"
#include "integrator/montecarlo/path_family.h"
#include "integrator/montecarlo/path_parameters.h"
#include "integrator/regions/crop_weights.h"

namespace ajar {

namespace {

ChainPlan::Direct direct_of(const std::string& text) {
  if (text == "omc") return ChainPlan::Direct::Omc;
  return text == "chain" ? ChainPlan::Direct::Chain : ChainPlan::Direct::None;
}

SeedFilter seed_filter_of(std::string_view text) {
  if (text == "filtered") return SeedFilter::Weighted;
  return text == "filtered-published" ? SeedFilter::Dropped : SeedFilter::None;
}

Vec2i crop_size(const RenderSettings& settings) { return settings.crop.size() + Vec2i(1, 1); }

}  // namespace

ChainPlan::ChainPlan(ChainKind chain_kind, const Scene& the_scene,
                     const RenderSettings& render_settings, const Parameters& the_parameters,
                     std::optional<SelectiveSettings> selective_settings)
    : kind(chain_kind),
      scene(the_scene),
      settings(render_settings),
      parameters(the_parameters),
      techniques(techniques_of_chains(parameters)),
      direct(direct_of(parameters.get_text("direct"))),
      selective(std::move(selective_settings)),
      omc_samples(parameters.get_float("omc-samples")),
      bootstrap(static_cast<std::uint64_t>(parameters.get_int("bootstrap"))),
      wanted_chains(static_cast<std::uint64_t>(parameters.get_int("chains"))),
      seed_rule{seed_filter_of(parameters.get_text("seeds")), parameters.get_float("seed-spread")},
      moves(parameters, kind) {
  if (has_explicit(kind)) path_mutations = path_mutation_weights(parameters);
  if (selective) check_region_rules(selective->rules, scene.object_names(), scene.material_names());
  settings.max_depth = std::min(settings.max_depth, MetropolisHeuristics::kMostEdges);
  read_split();
  if (kind == ChainKind::ByPath && !has_recruits()) kind = ChainKind::OnePath;
  if (kind == ChainKind::SpreadPath && thresholds.empty()) {
    throw UsageError(
        "chain=erpt: only where ordinary Monte Carlo finds the paths that chains start from, so "
        "with the same techniques and without split=0, choice=exclusive and direct=chain");
  }
  view = view_of(scene, settings);
  if (bootstrap > 0 && bootstrap < 1000) {
    throw UsageError(
        "bootstrap: at least 1000 samples, or 0 for as many as suit the picture, not " +
        std::to_string(bootstrap));
  }
  if (bootstrap == 0) {
    bootstrap = has_recruits() ? std::max(SelectiveHeuristics::kPilotSamples, pixels())
                               : std::max(SelectiveHeuristics::kBootstrapPaths,
                                          SelectiveHeuristics::kBootstrapOfPixel * pixels());
  }
  read_omc();
  make_groups();
  read_pilot();
  shares_effort = selective || (omc_samples == 0.0 && has_recruits());
  if (shares_effort || omc_samples == 0.0) omc_samples = 1.0;
  read_importance();
}

void ChainPlan::read_split() {
  const std::optional<double> fixed = parameters.get_number("split");
  const bool by_regions_alone = selective && (!selective->omc_shares || selective->exclusive);
  if (direct == Direct::Chain || by_regions_alone || (fixed && *fixed == 0.0)) return;
  standby_threshold = SelectiveHeuristics::kWhite * fixed.value_or(1.0);
  const auto offer = [&](std::span<const double> offers) {
    thresholds.assign(offers.begin(), offers.end());
  };
  if (fixed && selective) {
    for (const double times : SelectiveHeuristics::kThresholdsOverGiven) {
      thresholds.push_back(times * *fixed);
    }
  } else if (fixed) {
    thresholds = {*fixed};
  } else if (kind != ChainKind::WholePath) {
    offer(SelectiveHeuristics::kThresholds);
    if (selective) thresholds.push_back(SelectiveHeuristics::kHighestThreshold);
  } else if (selective) {
    offer(SelectiveHeuristics::kThresholdsOfWholePaths);
  } else {
    thresholds = {SelectiveHeuristics::kThresholdOfWholePaths};
  }
}

void ChainPlan::read_omc() {
  omc = {.techniques = parameters.get_text("techniques"), .roulette_start = 3};
  if (selective && thresholds.empty()) omc = path_family_defaults(selective->omc);
  const bool tells_light_paths = parameters.given().contains(kLightPathsPerPixel);
  if (tells_light_paths) omc.light_paths_per_pixel = parameters.get_float(kLightPathsPerPixel);
  chooses_omc = selective && selective->chooses_omc && !thresholds.empty() &&
                kind != ChainKind::WholePath && !tells_light_paths;
}

void ChainPlan::set_omc(const PathFamilyDefaults& choice) {
  omc = choice;
  techniques = TechniqueSet::parse(omc.techniques);
  make_groups();
}

void ChainPlan::read_pilot() {
  if (selective) {
    pilot_use = selective->pilot;
    pilot_samples =
        selective->pilot_samples > 0
            ? selective->pilot_samples
            : std::clamp(SelectiveHeuristics::kPilotSamples / pixels(),
                         SelectiveHeuristics::kFewestOfPixel, SelectiveHeuristics::kMostOfPixel);
    return;
  }
  const auto replicates = static_cast<std::uint64_t>(settings.replicates);
  const std::uint64_t in_round = pixels() * replicates;
  pilot_samples = (bootstrap + in_round - 1) / in_round * replicates;
  if (thresholds.size() > 1 || settings.replicates < 2)
    pilot_use = pilot_use_of(settings.replicates);
}

PrimarySettings ChainPlan::chain_settings_of(int replicate) const {
  constexpr double kRounding = 1.001;
  PrimarySettings own = moves.settings;
  if (moves.raster_steps_are_open && divisions &&
      static_cast<double>(divisions->of(replicate).highest_threshold()) <=
          SelectiveHeuristics::kNearlyAllLight * kRounding * brightness) {
    own.probabilities.raster = SelectiveHeuristics::kRasterStepsOfAllLight;
  }
  return own;
}

std::uint64_t ChainPlan::pixels() const {
  const Vec2i size = crop_size(settings);
  return static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y);
}

std::size_t ChainPlan::chains_per_replicate() const {
  const std::uint64_t in_pass =
      has_recruits() ? SelectiveHeuristics::kStepsOfRecruit : SelectiveHeuristics::kStepsOfSeed;
  const auto replicates = static_cast<std::uint64_t>(settings.replicates);
  if (wanted_chains > 0) return std::max<std::uint64_t>(1, wanted_chains / replicates);
  const auto steps = [&](double of_pixel) {
    return static_cast<std::uint64_t>(of_pixel * static_cast<double>(pixels())) / replicates;
  };
  const std::uint64_t expected =
      standby ? 0
              : std::min(steps(SelectiveHeuristics::kExpectedMutations) / in_pass,
                         SelectiveHeuristics::kMostExpectedChains);
  return std::max<std::uint64_t>({1, steps(mutations) / in_pass, expected,
                                  std::min(steps(mutations), SelectiveHeuristics::kFewestChains)});
}

const PathGroup& ChainPlan::group_of(int depth) const {
  const auto& own = is_explicit(kind) ? depth_groups_ : groups;
  const auto group = std::find_if(own.begin(), own.end(),
                                  [&](const PathGroup& one) { return one.depth == depth; });
  if (group == own.end()) throw std::logic_error("bug: no chains for paths of this depth");
  return *group;
}

const PathGroup& ChainPlan::group_of(const StrongPath& found) const {
  const PathGroup& last = groups.back();
  if (is_explicit(last.kind) && has_paths(last.paths, found.hit_only)) return last;
  return group_of(found.technique.depth());
}

void ChainPlan::make_groups() {
  PathSamplerSettings sampler;
  sampler.techniques = techniques;
  sampler.heuristic = heuristic_of(parameters);
  sampler.min_depth = direct == Direct::Chain
                          ? settings.min_depth
                          : std::max(settings.min_depth, Division::kDirectDepth + 1);
  sampler.max_depth = settings.max_depth;
  sampler.counted = settings.counted;
  // As ordinary Monte Carlo counts them, so that both agree about what a path brings.
  if (has_recruits()) sampler.light_subpaths = omc.light_paths_per_pixel;
  sampler.light_paths_per_pixel =
      sampler.light_subpaths * static_cast<double>(pixels()) /
      (static_cast<double>(settings.resolution.x) * settings.resolution.y);
  const int roulette_start = kind == ChainKind::OnePath ? 0 : parameters.get_int("roulette-start");
  groups = make_path_groups(scene, kind, sampler, roulette_start);
  if (is_explicit(kind)) {
    depth_groups_ = make_path_groups(scene, ChainKind::OnePath, sampler, 0);
  }
}

void ChainPlan::read_importance() {
  const std::string& text = parameters.get_text("importance");
  if (text == "uniform" || text == "relative") return;  // the pilot finds the latter
  std::vector<float> weights = read_crop_weights("importance", text, settings);
  try {
    view.importance = ImportanceMap(settings.crop, std::move(weights));
  } catch (const std::invalid_argument&) {
    throw UsageError("importance: " + text + " is black everywhere");
  }
}

std::unique_ptr<PathTarget> ChainPlan::make_target(const PathGroup& group, int replicate) const {
  return make_path_target(scene, group, view, part_of(replicate));
}

std::unique_ptr<PathTarget> ChainPlan::make_seed_target(const PathGroup& group,
                                                        int replicate) const {
  return ajar::make_seed_target(scene, group, view, part_of(replicate));
}

void ChainPlan::leave_to_omc(Shortage shortage, std::uint64_t kept) {
  unprepared = shortage;
  ray_price.reset();
  // What is kept has been summed up in its units.
  if (kept == 0) scale_.reset();
  shares_effort = false;
  mutations = 0.0;
  omc_samples = 1.0;
  pilot_kept = kept;
  divisions.emplace(
      Division(settings.crop, {{.threshold = 0.F, .target = 0.F, .kept = 0.F}}, view.importance));
}

std::pair<int, int> ChainPlan::omc_depths() const {
  if (unprepared && direct == Direct::Chain) return {settings.min_depth, settings.max_depth};
  return {direct == Direct::Omc ? settings.min_depth
                                : std::max(settings.min_depth, Division::kDirectDepth + 1),
          divisions ? settings.max_depth : std::min(settings.max_depth, Division::kDirectDepth)};
}

RenderSettings ChainPlan::omc_settings() const {
  RenderSettings own = settings;
  std::erase_if(own.aovs, [](const std::string& name) {
    return is_chain_layer(name) || name == "techniques";
  });
  return own;
}

Parameters ChainPlan::omc_parameters() const {
  return {path_family_parameters(omc), {{"heuristic", parameters.get_text("heuristic")}}};
}

std::unique_ptr<Integrator> ChainPlan::make_omc(const RenderSettings& omc_settings,
                                                std::pair<int, int> depths,
                                                PathIntegratorContext context) const {
  RenderSettings own = omc_settings;
  own.min_depth = depths.first;
  own.max_depth = depths.second;
  const Parameters of_omc = omc_parameters();
  if (!scale_ || scale_depths_ != depths) {
    scale_ = measure_scale(scene, own, of_omc);
    scale_depths_ = depths;
  }
  context.scale = scale_;
  if (context.price == nullptr && ray_price) context.price = &*ray_price;
  return make_path_integrator(scene, own, of_omc, context);
}

}  // namespace ajar
