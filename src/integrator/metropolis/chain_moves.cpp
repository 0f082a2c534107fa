#include "integrator/metropolis/chain_moves.h"

#include "mcmc/primary/make_mutation.h"

namespace ajar {

std::vector<ParameterSpec> ChainMoves::parameters(const Defaults& defaults) {
  std::vector<ParameterSpec> specs = {
      {.name = "mutation",
       .type = ParameterType::Choice,
       .default_value = defaults.mutation,
       .unit = "",
       .help =
           "how small steps move a number: by kelemen's exponential distribution of lengths, or "
           "a gaussian of width sigma",
       .choices = {mutation_names().begin(), mutation_names().end()}},
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
       .maximum = 1.0},
      {.name = "mis-large-steps",
       .type = ParameterType::Bool,
       .default_value = "false",
       .unit = "",
       .help = "large steps count as ordinary Monte Carlo samples, too (Kelemen et al. 2002)",
       .choices = {}}};
  mark_experts(specs, {"mutation", "sigma", "large-step"});
  return specs;
}

ChainMoves::ChainMoves(const Parameters& parameters, std::string_view mutation_name)
    : mutation(make_mutation(mutation_name, parameters.get_float("sigma"))),
      mis_large_steps(parameters.get_bool("mis-large-steps")) {
  settings.probabilities.large = parameters.get_float("large-step");
  // Half moves keep the technique, so that the other half need not be traced again.
  settings.connection = {false, false};
}

}  // namespace ajar
