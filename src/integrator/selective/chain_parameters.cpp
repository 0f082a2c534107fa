#include <utility>

#include "integrator/metropolis/path_space.h"
#include "integrator/montecarlo/path_family.h"
#include "integrator/montecarlo/path_parameters.h"
#include "integrator/selective/chain_family.h"
#include "integrator/selective/selective_moves.h"

namespace ajar {

std::vector<ParameterSpec> chain_parameters(ChainKind kind) {
  // Chains that make a part of the light only, next to independent samples, need few of their own.
  std::vector<ParameterSpec> specs = SelectiveMoves::parameters();
  specs.insert(
      specs.end(),
      {techniques_parameter("bdpt"),
       heuristic_parameter(),
       {.name = "bootstrap",
        .type = ParameterType::Int,
        .default_value = "0",
        .unit = "samples",
        .help =
            "independent samples from which chains are seeded: of ordinary Monte Carlo, where it "
            "shares the light with mmlt or mlt (split), else paths over all depths and replicates; "
            "0: as "
            "many as suit the picture",
        .choices = {},
        .minimum = 0,
        .maximum = 100000000},
       {.name = "seeds",
        .type = ParameterType::Choice,
        .default_value = "all",
        .unit = "",
        .help = "bootstrap paths that chains start from: all, in proportion to what they carry; "
                "filtered: outliers less often, but with more weight; filtered-published: outliers "
                "never, which is biased while chains are short (after He 2018)",
        .choices = {"all", "filtered", "filtered-published"}},
       {.name = "seed-spread",
        .type = ParameterType::Float,
        .default_value = "3",
        .unit = "standard deviations",
        .help = "how far above the mean an outlier among the seeds lies",
        .choices = {},
        .minimum = 0.0,
        .maximum = 1e6},
       {.name = "chains",
        .type = ParameterType::Int,
        .default_value = "0",
        .unit = "",
        .help = "number of Markov chains; 0: as many as suit the size of the picture",
        .choices = {},
        .minimum = 0,
        .maximum = 1000000},
       {.name = "direct",
        .type = ParameterType::Choice,
        .default_value = "omc",
        .unit = "",
        .help =
            "who makes paths of up to two edges: omc (ordinary Monte Carlo), chain (the chains, "
            "which then make all light, as with split=0), or nobody (none)",
        .choices = {"omc", "chain", "none"}},
       number_parameter(
           "split", "auto",
           "ordinary Monte Carlo makes what long paths bring up to about so many times the "
           "brightness of their pixel, chains what is beyond; 0: chains make all of it; auto: "
           "found out by a pilot (10 for pssmlt)",
           1e6, {"auto"}),
       {.name = "omc-samples",
        .type = ParameterType::Float,
        .default_value = kind == ChainKind::WholePath ? "0.5" : "0",
        .unit = "",
        .help =
            "camera samples of ordinary Monte Carlo per mutation; 0: a sample is one camera sample "
            "and as many mutations as pay",
        .choices = {},
        .minimum = 0.0,
        .maximum = 16.0},
       {.name = "importance",
        .type = ParameterType::Text,
        .default_value = "relative",
        .unit = "",
        .help =
            "where chains spend their time: uniform (in proportion to brightness), relative "
            "(equal relative error everywhere), or an image file whose brightness is the weight",
        .choices = {}}});
  mark_experts(specs, {"techniques", "large-step", "bootstrap", "direct", "importance"});
  if (has_explicit(kind)) {
    for (ParameterSpec& spec : path_mutation_parameters()) {
      spec.expert = true;
      specs.push_back(std::move(spec));
    }
  }
  if (kind != ChainKind::WholePath) {
    specs.push_back(light_paths_parameter(
        1.0,
        "light subpaths of ordinary Monte Carlo per camera sample, if the techniques have any"));
  }
  if (kind != ChainKind::OnePath) {
    specs.push_back(roulette_start_parameter(3));
    specs.back().expert = true;
  }
  return specs;
}

}  // namespace ajar
