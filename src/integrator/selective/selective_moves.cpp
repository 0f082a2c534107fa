#include "integrator/selective/selective_moves.h"

#include <optional>
#include <string_view>

#include "core/error.h"
#include "integrator/selective/heuristics.h"

namespace ajar {

namespace {

bool leaves_for_neighbours(std::string_view name) { return name == "slemmlt" || name == "fusion"; }
/// What moves numbers where the image plane does not.
std::string_view base_mutation(std::string_view name) {
  return leaves_for_neighbours(name) ? "gaussian" : name;
}

/// With the constants of He et al. 2020.
void add_plane_parameters(std::vector<ParameterSpec>& specs) {
  specs.push_back(choice_parameter(
      "step", {"fixed", "adaptive"},
      "length of small steps: fixed, or adaptive to how evenly chains visit the pixels around (He "
      "et al. 2020)"));
  specs.push_back(choice_parameter(
      "rule", {"exact", "published"},
      "for step=adaptive, slemmlt and fusion: exact keeps the picture's expectation; published is "
      "biased, for comparison only"));
  specs.push_back(
      number_parameter("m1", "50", "adaptive: visits before a pixel's steps may change (M1)"));
  specs.push_back(number_parameter(
      "k1", "50", "adaptive: variance of visits above which steps are shorter (k1)"));
  specs.push_back(number_parameter(
      "k2", "10", "adaptive: variance of visits below which steps are longer (k2)"));
  specs.push_back(number_parameter("lambda1", "23",
                                   "adaptive: shorter steps are lambda1 / variance as long (λ1)"));
  specs.push_back(number_parameter("lambda2", "0.7",
                                   "adaptive: longer steps are lambda2 · variance as long (λ2)"));
  specs.push_back(number_parameter(
      "w", "100", "slemmlt: visits from which on steps leave for a neighbour (W)"));
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

}  // namespace

std::vector<ParameterSpec> SelectiveMoves::parameters() {
  std::vector<ParameterSpec> specs =
      ChainMoves::parameters({.mutation = "gaussian", .large_step = "0.1"});
  ParameterSpec& mutation = specs.front();
  mutation.help +=
      "; slemmlt: from much visited pixels to their neighbours (He et al. 2019); fusion: slemmlt "
      "with step=adaptive";
  mutation.choices.insert(mutation.choices.end(), {"slemmlt", "fusion"});
  const std::string fine_help =
      "share of the small steps that have 1/8 or 1/64 of their length, for light that is found in "
      "narrow places; not with kelemen, whose steps cannot be divided; by default none there, or "
      "where steps follow the picture (step=adaptive, slemmlt, fusion)";
  specs.push_back(number_parameter("fine-steps", "0.2", fine_help, 1.0));
  const std::string raster_help =
      "share of the small steps that move nothing but a path's place on the picture, and keep its "
      "directions; auto: 0.7, or 0.9 where chains make nearly all light; none for pssmlt, with "
      "several tries, or where steps follow the picture (step=adaptive, slemmlt, fusion)";
  specs.push_back(number_parameter("raster-steps", "auto", raster_help, 1.0, {"auto"}));
  specs.push_back(number_parameter(
      "camera-steps", "0",
      "share of the other small steps that move the camera's half of a path only", 1.0));
  specs.push_back(number_parameter(
      "light-steps", "0",
      "share of the other small steps that move the light's half of a path only", 1.0));
  specs.push_back(
      {.name = "multi-try",
       .type = ParameterType::Int,
       .default_value = "1",
       .unit = "paths",
       .help =
           "proposals per mutation, of which one is chosen; all of them are counted (multiple-"
           "try Metropolis); steps of raster-steps, and those that follow the picture, have one",
       .choices = {},
       .minimum = 1,
       .maximum = 64});
  add_plane_parameters(specs);
  return specs;
}

SelectiveMoves::SelectiveMoves(const Parameters& parameters, ChainKind kind)
    : ChainMoves(parameters, base_mutation(parameters.get_text("mutation"))),
      plane(plane_rule(parameters)) {
  StepProbabilities& probabilities = settings.probabilities;
  if (is_explicit(kind)) {
    // Such chains have no numbers that could move, nor a step that is independent of their state.
    probabilities = {.large = 0.0};
    return;
  }
  probabilities.camera_half = parameters.get_float("camera-steps");
  probabilities.light_half = parameters.get_float("light-steps");
  settings.tries = parameters.get_int("multi-try");
  if (probabilities.camera_half + probabilities.light_half > 1.0) {
    throw UsageError(
        "camera-steps and light-steps are shares of the small steps besides raster-steps: "
        "together at most 1");
  }
  // Where the plane says how long steps are, there is no need for others unless the user has one.
  const bool wants_fine =
      parameters.given().contains("fine-steps") || (mutation->divisible() && !plane.active());
  probabilities.fine = wants_fine ? parameters.get_float("fine-steps") : 0.0;
  if (probabilities.fine > 0.0 && !mutation->divisible()) {
    throw UsageError("fine-steps: not with mutation=" + parameters.get_text("mutation") +
                     ", whose steps cannot be divided: gaussian, slemmlt or fusion");
  }
  if (const std::optional<double> share = parameters.get_number("raster-steps")) {
    probabilities.raster = *share;
  } else if (has_one_path(kind) && settings.tries == 1 && !plane.active()) {
    // What they leave as it is, a state of pssmlt would trace again.
    probabilities.raster = SelectiveHeuristics::kRasterSteps;
    raster_steps_are_open = true;
  }
}

}  // namespace ajar
