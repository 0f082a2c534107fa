#include "integrator/selective/config.h"

#include <algorithm>
#include <stdexcept>

#include "core/error.h"
#include "integrator/division.h"
#include "integrator/metropolis/chain_film_sink.h"
#include "integrator/metropolis/heuristics.h"
#include "integrator/metropolis/path_space.h"
#include "integrator/montecarlo/path_parameters.h"
#include "integrator/regions/crop_weights.h"
#include "integrator/selective/heuristics.h"
#include "mcmc/primary/gaussian_mutation.h"

namespace ajar {

namespace {

/// Value of a parameter that a pilot decides.
constexpr const char* kAuto = "auto";

ParameterSpec techniques_spec() {
  ParameterSpec spec = techniques_parameter(kAuto);
  spec.help += "; auto: ibpt or bdpt, as a pilot finds";
  return spec;
}

ParameterSpec light_paths_spec() {
  ParameterSpec spec = light_paths_parameter(
      1.0, "light subpaths of ordinary Monte Carlo per camera sample, if the techniques have any");
  spec.default_value = kAuto;
  spec.choices = {kAuto};
  spec.help += "; auto: as a pilot finds";
  return spec;
}

ChainSpace kind_of(const std::string& chain) {
  if (chain == "mlt") return ChainSpace::Paths;
  return chain == "mmlt" ? ChainSpace::Mmlt : ChainSpace::Auto;
}

/// Cross-fitting needs two replicates in each half, which tell a variance.
SelectiveConfig::PilotSamples pilot_of(const std::string& text, int replicates) {
  constexpr int kTwoHalves = 4;
  return text == "discard" || replicates < kTwoHalves ? SelectiveConfig::PilotSamples::Discard
                                                      : SelectiveConfig::PilotSamples::CrossFit;
}

PathFamilyDefaults omc_of(const Parameters& parameters) {
  const std::string& techniques = parameters.get_text("techniques");
  PathFamilyDefaults omc = path_family_defaults("bdpt");
  if (techniques != kAuto) {
    omc.techniques = techniques;
    omc.roulette_start = path_family_defaults(techniques).roulette_start;
  }
  if (const auto light_paths = parameters.get_number(kLightPathsPerPixel)) {
    omc.light_paths_per_pixel = *light_paths;
  }
  if (!TechniqueSet::parse(omc.techniques).tries_once()) {
    throw UsageError("techniques: Markov chains try each technique once, so leave out counts: " +
                     omc.techniques);
  }
  return omc;
}

std::vector<double> thresholds_of(std::optional<double> split) {
  if (split) return {*split};
  return {SelectiveHeuristics::kThresholds.begin(), SelectiveHeuristics::kThresholds.end()};
}

ChainView view_with_importance(const Scene& scene, const RenderSettings& settings,
                               const std::string& importance) {
  ChainView view = view_of(scene, settings);
  if (importance == "uniform" || importance == "relative") return view;
  std::vector<float> weights = read_crop_weights("importance", importance, settings);
  try {
    view.importance = ImportanceMap(settings.crop, std::move(weights));
  } catch (const std::invalid_argument&) {
    throw UsageError("importance: " + importance + " is black everywhere");
  }
  return view;
}

PrimarySettings primary_moves_of(ChainSpace kind) {
  PrimarySettings moves;
  if (is_explicit(kind)) {
    moves.probabilities = {.large = 0.0};
    return moves;
  }
  moves.probabilities.large = SelectiveHeuristics::kLargeSteps;
  moves.probabilities.fine = SelectiveHeuristics::kFineSteps;
  moves.probabilities.raster = SelectiveHeuristics::kRasterSteps;
  // Half moves keep the technique, so that the other half need not be traced again.
  moves.connection = {false, false};
  return moves;
}

std::vector<double> default_path_mutations() {
  return path_mutation_weights(Parameters(path_mutation_parameters(), {}));
}

ParameterSpec roulette_spec() {
  ParameterSpec spec = roulette_parameter(kAuto);
  spec.choices.insert(spec.choices.begin(), kAuto);
  spec.help += "; auto: the former, unless techniques connect subpaths of both ends";
  return spec;
}

}  // namespace

std::vector<ParameterSpec> SelectiveConfig::parameters() {
  std::vector<ParameterSpec> specs = {
      choice_parameter(
          "chain", {kAuto, "mmlt", "mlt"},
          "the Markov chains: mmlt, in primary sample space; mlt, in path space; auto: "
          "mlt for paths that no connection makes (a lamp seen by way of glass, a "
          "matte surface and glass), mmlt for the others"),
      choice_parameter("objective", {"filtered", "raw"},
                       "picture whose error is to be least: the filtered one, to which clumps of "
                       "chains do more harm than noise, or the one that is rendered"),
      UserRegions::parameter(),
      choice_parameter("edges", {"none", "antialias"},
                       "smooth the stairs that the division leaves at the edges of objects, in "
                       ".png and .jpg"),
      techniques_spec(),
      {.name = "importance",
       .type = ParameterType::Text,
       .default_value = "relative",
       .unit = "",
       .help = "where chains spend their time: uniform (in proportion to brightness), relative "
               "(equal relative error everywhere), or an image file whose brightness is the weight",
       .choices = {}},
      light_paths_spec(),
      choice_parameter(
          "pilot", {"cross", "discard"},
          "samples that the division is decided from: cross-fitted (kept; each half of "
          "the replicates has the division of the other half's samples; needs 4 "
          "replicates, else discard), or discarded"),
      roulette_spec(),
      number_parameter("split", kAuto,
                       "T: brightness, relative to the pixel's, of paths that ordinary Monte "
                       "Carlo and chains share evenly; auto: as a pilot finds, region by region",
                       1e6, {kAuto})};
  ParameterSpec& split = specs.back();
  split.minimum = 0.0;
  split.open_range = true;
  mark_experts(specs, {"chain", "objective", "regions", "edges", "techniques", "importance",
                       kLightPathsPerPixel});
  return specs;
}

SelectiveConfig::SelectiveConfig(const Scene& the_scene, const RenderSettings& render_settings,
                                 const Parameters& parameters)
    : scene(the_scene),
      settings(render_settings),
      kind(kind_of(parameters.get_text("chain"))),
      objective(parameters.get_text("objective") == "raw" ? Objective::Raw : Objective::Filtered),
      pilot(pilot_of(parameters.get_text("pilot"), settings.replicates)),
      pilot_samples(std::clamp(SelectiveHeuristics::kPilotSamples / pixels(),
                               SelectiveHeuristics::kFewestOfPixel,
                               SelectiveHeuristics::kMostOfPixel)),
      roulette(parameters.get_text("roulette")),
      antialias(parameters.get_text("edges") == "antialias"),
      regions(UserRegions::read(parameters.get_text("regions"), scene, settings)),
      omc(omc_of(parameters)),
      chooses_techniques(parameters.get_text("techniques") == kAuto &&
                         !parameters.get_number(kLightPathsPerPixel)),
      chooses_division(regions.empty() && !parameters.get_number("split")),
      thresholds(thresholds_of(parameters.get_number("split"))),
      fireflies_threshold(SelectiveHeuristics::kDisplayWhite *
                          parameters.get_number("split").value_or(1.0)),
      relative_importance(parameters.get_text("importance") == "relative"),
      view(view_with_importance(scene, settings, parameters.get_text("importance"))),
      mutation(std::make_shared<GaussianMutation>()),
      moves(primary_moves_of(kind)),
      path_mutations(default_path_mutations()) {
  settings.max_depth = std::min(settings.max_depth, MetropolisHeuristics::kMostEdges);
  if (!parameters.get_number("split")) {
    thresholds.push_back(SelectiveHeuristics::kHighestThreshold);
  }
}

std::uint64_t SelectiveConfig::pixels() const {
  const Vec2i size = settings.crop.size() + Vec2i(1, 1);
  return static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y);
}

bool SelectiveConfig::has_long_paths() const {
  return std::max(settings.min_depth, Division::kDirectDepth + 1) <= settings.max_depth;
}

}  // namespace ajar
