#include "integrator/metropolis/mmlt_extensions.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "core/error.h"

namespace ajar {

namespace {

bool leaves_for_neighbours(std::string_view name) { return name == "slemmlt" || name == "fusion"; }

/// The mutation of all numbers but those that follow the image plane.
std::string_view base_mutation(std::string_view name) {
  return leaves_for_neighbours(name) ? "gaussian" : name;
}

PlaneRule plane_rule(const Parameters& parameters) {
  const std::string& name = parameters.get_text("mutation");
  PlaneRule rule;
  rule.adaptive = parameters.get_text("step") == "adaptive" || name == "fusion";
  rule.neighbours = leaves_for_neighbours(name);
  rule.published = parameters.get_text("rule") == "published";
  rule.adaptive_visits = parameters.get_float("m1");
  rule.uneven = parameters.get_float("k1");
  rule.even = parameters.get_float("k2");
  rule.shorten = parameters.get_float("lambda1");
  rule.lengthen = parameters.get_float("lambda2");
  rule.neighbour_visits = parameters.get_float("w");
  return rule;
}

SeedRule seed_rule(const Parameters& parameters) {
  const std::string& text = parameters.get_text("seeds");
  const SeedFilter filter = text == "filtered"             ? SeedFilter::Weighted
                            : text == "filtered-published" ? SeedFilter::Dropped
                                                           : SeedFilter::None;
  return {filter, parameters.get_float("seed-spread")};
}

std::vector<ParameterSpec> own_parameters() {
  return {
      choice_parameter("step", {"fixed", "adaptive"},
                       "length of small steps: fixed, or adaptive to how evenly chains visit the "
                       "pixels around (He et al. 2020)"),
      choice_parameter("rule", {"exact", "published"},
                       "for step=adaptive, slemmlt and fusion: exact keeps the picture's "
                       "expectation; published is biased, for comparison only"),
      number_parameter("m1", "50", "adaptive: visits before a pixel's steps may change (M1)"),
      number_parameter("k1", "50",
                       "adaptive: variance of visits above which steps are shorter (k1)"),
      number_parameter("k2", "10",
                       "adaptive: variance of visits below which steps are longer (k2)"),
      number_parameter("lambda1", "23",
                       "adaptive: shorter steps are lambda1 / variance as long (λ1)"),
      number_parameter("lambda2", "0.7",
                       "adaptive: longer steps are lambda2 · variance as long (λ2)"),
      number_parameter("w", "100", "slemmlt: visits from which on steps leave for a neighbour (W)"),
      {.name = "multi-try",
       .type = ParameterType::Int,
       .default_value = "1",
       .unit = "paths",
       .help = "proposals per mutation, one of which is chosen; all are counted (multiple-try "
               "Metropolis); steps that follow the image plane have one",
       .choices = {},
       .minimum = 1,
       .maximum = 64},
      choice_parameter("seeds", {"all", "filtered", "filtered-published"},
                       "bootstrap paths that chains start from: all, in proportion to what they "
                       "carry; filtered: outliers less often, but with more weight; "
                       "filtered-published: outliers never, which is biased while chains are short "
                       "(after He 2018)"),
      {.name = "seed-spread",
       .type = ParameterType::Float,
       .default_value = "3",
       .unit = "standard deviations",
       .help = "how far above the mean an outlier among the seeds lies",
       .choices = {},
       .minimum = 0.0,
       .maximum = 1e6},
      number_parameter("camera-steps", "0",
                       "share of the small steps that move the camera's half of a path only", 1.0),
      number_parameter("light-steps", "0",
                       "share of the small steps that move the light's half of a path only", 1.0)};
}

}  // namespace

void add_mmlt_extensions(std::vector<ParameterSpec>& specs) {
  const auto mutation = std::find_if(specs.begin(), specs.end(), [](const ParameterSpec& spec) {
    return spec.name == "mutation";
  });
  mutation->help +=
      "; slemmlt: from much visited pixels to their neighbours (He et al. 2019); fusion: slemmlt "
      "with step=adaptive";
  mutation->choices.insert(mutation->choices.end(), {"slemmlt", "fusion"});
  for (ParameterSpec& spec : own_parameters()) {
    spec.expert = true;
    specs.push_back(std::move(spec));
  }
}

ChainMoves mmlt_moves(const Parameters& parameters) {
  ChainMoves moves(parameters, base_mutation(parameters.get_text("mutation")));
  moves.plane = plane_rule(parameters);
  moves.seeds = seed_rule(parameters);
  moves.settings.tries = parameters.get_int("multi-try");
  StepProbabilities& probabilities = moves.settings.probabilities;
  probabilities.camera_half = parameters.get_float("camera-steps");
  probabilities.light_half = parameters.get_float("light-steps");
  if (probabilities.camera_half + probabilities.light_half > 1.0) {
    throw UsageError(
        "camera-steps and light-steps are shares of the small steps: together at most 1");
  }
  return moves;
}

}  // namespace ajar
