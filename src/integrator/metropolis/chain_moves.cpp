#include "integrator/metropolis/chain_moves.h"

#include <optional>
#include <string_view>

#include "core/error.h"
#include "integrator/metropolis/heuristics.h"
#include "mcmc/primary/make_mutation.h"

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

std::vector<ParameterSpec> ChainMoves::parameters(const Defaults& defaults) {
  std::vector<std::string> mutations(mutation_names().begin(), mutation_names().end());
  mutations.insert(mutations.end(), {"slemmlt", "fusion"});
  std::vector<ParameterSpec> specs = {
      {.name = "mutation",
       .type = ParameterType::Choice,
       .default_value = defaults.mutation,
       .unit = "",
       .help =
           "how small steps move a number: by kelemen's exponential distribution of lengths, or "
           "a gaussian of width sigma; slemmlt: from much visited pixels to their neighbours (He "
           "et al. 2019); fusion: slemmlt with step=adaptive",
       .choices = mutations},
      {.name = "sigma",
       .type = ParameterType::Float,
       .default_value = "0.01",
       .unit = "",
       .help = "standard deviation of gaussian small steps, as a share of the unit interval",
       .choices = {},
       .minimum = 1e-6,
       .maximum = 0.5},
      {.name = "large-step",
       .type = ParameterType::Float,
       .default_value = defaults.large_step,
       .unit = "",
       .help = "probability of a step that makes the whole path afresh",
       .choices = {},
       .minimum = 0.001,
       .maximum = 1.0}};
  std::string fine_help =
      "share of the small steps that have 1/8 or 1/64 of their length, for light that is found in "
      "narrow places; not with kelemen, whose steps cannot be divided";
  if (defaults.fine_steps != "0") {
    fine_help +=
        "; by default none there, or where steps follow the picture (step=adaptive, "
        "slemmlt, fusion)";
  }
  specs.push_back(number_parameter("fine-steps", defaults.fine_steps, fine_help, 1.0));
  std::string raster_help =
      "share of the small steps that move nothing but a path's place on the picture, and keep its "
      "directions";
  std::vector<std::string> raster_words;
  if (defaults.raster_steps == "auto") {
    raster_words = {"auto"};
    raster_help +=
        "; auto: 0.7, or 0.9 where chains make nearly all light; none for pssmlt, with "
        "several tries, or where steps follow the picture (step=adaptive, slemmlt, "
        "fusion)";
  }
  specs.push_back(
      number_parameter("raster-steps", defaults.raster_steps, raster_help, 1.0, raster_words));
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
  specs.push_back(
      {.name = "mis-large-steps",
       .type = ParameterType::Bool,
       .default_value = "false",
       .unit = "",
       .help = "large steps count as ordinary Monte Carlo samples, too (Kelemen et al. 2002)",
       .choices = {}});
  add_plane_parameters(specs);
  mark_experts(specs, {"mutation", "sigma", "large-step"});
  return specs;
}

ChainMoves::ChainMoves(const Parameters& parameters, ChainKind kind)
    : mutation(make_mutation(base_mutation(parameters.get_text("mutation")),
                             parameters.get_float("sigma"))),
      plane(plane_rule(parameters)),
      mis_large_steps(parameters.get_bool("mis-large-steps")) {
  StepProbabilities& probabilities = settings.probabilities;
  probabilities = {parameters.get_float("large-step"), parameters.get_float("camera-steps"),
                   parameters.get_float("light-steps")};
  settings.tries = parameters.get_int("multi-try");
  // Half moves keep the technique, so that the other half need not be traced again.
  settings.connection = {false, false};
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
  } else if (kind == ChainKind::OnePath && settings.tries == 1 && !plane.active()) {
    // What they leave as it is, a state of pssmlt would trace again.
    probabilities.raster = MetropolisHeuristics::kRasterSteps;
    raster_steps_are_open = true;
  }
}

}  // namespace ajar
