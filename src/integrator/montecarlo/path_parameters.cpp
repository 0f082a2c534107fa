#include "integrator/montecarlo/path_parameters.h"

#include <fmt/format.h>

#include <utility>

namespace ajar {

ParameterSpec techniques_parameter(std::string default_value, std::string more_help) {
  return {.name = "techniques",
          .type = ParameterType::Text,
          .default_value = std::move(default_value),
          .unit = "",
          .help =
              "how paths are built: a list of pt, lt, ibpt, bdpt, implicit, explicit, light, "
              "inner and (s,t) pairs" +
              std::move(more_help),
          .choices = {}};
}

ParameterSpec light_paths_parameter(double default_value, std::string help) {
  return {.name = kLightPathsPerPixel,
          .type = ParameterType::Float,
          .default_value = fmt::format("{}", default_value),
          .unit = "",
          .help = std::move(help),
          .choices = {},
          .minimum = 0.001,
          .maximum = PathSampler::kMaxLightSubpaths};
}

ParameterSpec heuristic_parameter() {
  return choice_parameter("heuristic", {"power", "balance"},
                          "how techniques that find the same path share it (Veach & Guibas 1995)");
}

ParameterSpec roulette_parameter(std::string default_value) {
  ParameterSpec spec = choice_parameter(
      "roulette", {"efficient", "usual"},
      "Russian roulette: by what rays bring for their price, as the render finds it (Rath et al. "
      "2022); or by throughput alone");
  spec.default_value = std::move(default_value);
  return spec;
}

ParameterSpec roulette_start_parameter(int default_value) {
  return {.name = "roulette-start",
          .type = ParameterType::Int,
          .default_value = fmt::format("{}", default_value),
          .unit = "edges",
          .help = "path length from which Russian roulette may end a dim path",
          .choices = {},
          .minimum = 1,
          .maximum = 60000};
}

Heuristic heuristic_of(const Parameters& parameters) {
  return parameters.get_text("heuristic") == "power" ? Heuristic::Power : Heuristic::Balance;
}

}  // namespace ajar
