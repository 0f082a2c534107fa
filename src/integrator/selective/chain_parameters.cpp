#include <utility>

#include "integrator/montecarlo/path_family.h"
#include "integrator/selective/chain_family.h"
#include "mcmc/primary/make_mutation.h"

namespace ajar {

namespace {

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

}  // namespace

std::vector<ParameterSpec> chain_parameters(ChainKind kind) {
  std::vector<std::string> mutations(mutation_names().begin(), mutation_names().end());
  mutations.insert(mutations.end(), {"slemmlt", "fusion"});
  std::vector<ParameterSpec> specs = {
      {.name = "techniques",
       .type = ParameterType::Text,
       .default_value = "bdpt",
       .unit = "",
       .help =
           "how paths are built: a list of pt, lt, ibpt, bdpt, implicit, explicit, light, inner "
           "and (s,t) pairs",
       .choices = {}},
      {.name = "heuristic",
       .type = ParameterType::Choice,
       .default_value = "power",
       .unit = "",
       .help = "how techniques that find the same path share it (Veach & Guibas 1995)",
       .choices = {"power", "balance"}},
      {.name = "mutation",
       .type = ParameterType::Choice,
       .default_value = "gaussian",
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
       .default_value = "0.1",
       .unit = "",
       .help = "probability of a step that makes the whole path afresh",
       .choices = {},
       .minimum = 0.001,
       .maximum = 1.0},
      number_parameter(
          "fine-steps", "0.2",
          "share of the small steps that have 1/8 or 1/64 of their length, for light that is "
          "found in narrow places; by default none where steps follow the picture (step=adaptive, "
          "slemmlt, fusion) or cannot be divided (kelemen)",
          1.0),
      number_parameter(
          "raster-steps", "auto",
          "share of the small steps that move nothing but a path's place on the picture, and keep "
          "its directions; auto: 0.7, or 0.9 where chains make nearly all light; none for pssmlt, "
          "with several tries, or where steps follow the picture (step=adaptive, slemmlt, fusion)",
          1.0, {"auto"}),
      number_parameter("camera-steps", "0",
                       "share of the other small steps that move the camera's half of a path only",
                       1.0),
      number_parameter("light-steps", "0",
                       "share of the other small steps that move the light's half of a path only",
                       1.0),
      {.name = "bootstrap",
       .type = ParameterType::Int,
       .default_value = "0",
       .unit = "samples",
       .help =
           "independent samples from which chains are seeded: of ordinary Monte Carlo, where it "
           "shares the light with mmlt (split), else paths over all depths and replicates; 0: as "
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
       .help = "who makes paths of up to two edges: omc (ordinary Monte Carlo), chain (the chains, "
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
       .default_value = kind == ChainKind::OnePath ? "0" : "0.5",
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
       .help = "where chains spend their time: uniform (in proportion to brightness), relative "
               "(equal relative error everywhere), or an image file whose brightness is the weight",
       .choices = {}},
      {.name = "multi-try",
       .type = ParameterType::Int,
       .default_value = "1",
       .unit = "paths",
       .help =
           "proposals per mutation, of which one is chosen; all of them are counted (multiple-"
           "try Metropolis); steps of raster-steps, and those that follow the picture, have one",
       .choices = {},
       .minimum = 1,
       .maximum = 64},
      {.name = "mis-large-steps",
       .type = ParameterType::Bool,
       .default_value = "false",
       .unit = "",
       .help = "large steps count as ordinary Monte Carlo samples, too (Kelemen et al. 2002)",
       .choices = {}}};
  add_plane_parameters(specs);
  mark_experts(specs, {"techniques", "large-step", "bootstrap", "direct", "importance"});
  if (kind == ChainKind::OnePath) {
    specs.push_back(
        {.name = kLightPathsPerPixel,
         .type = ParameterType::Float,
         .default_value = "1",
         .unit = "",
         .help =
             "light subpaths of ordinary Monte Carlo per camera sample, if the techniques have any",
         .choices = {},
         .minimum = 0.001,
         .maximum = PathSampler::kMaxLightSubpaths});
  }
  if (kind == ChainKind::WholePath) {
    specs.push_back({.name = "roulette-start",
                     .type = ParameterType::Int,
                     .default_value = "3",
                     .unit = "edges",
                     .help = "path length from which Russian roulette may end a dim path",
                     .choices = {},
                     .minimum = 1,
                     .maximum = 60000,
                     .expert = true});
  }
  return specs;
}

}  // namespace ajar
