#pragma once
#include <string>

#include "core/parameters.h"
#include "transport/path_sampler.h"

/// Parameters that every method which samples paths has.
namespace ajar {

ParameterSpec techniques_parameter(std::string default_value, std::string more_help = "");
/// The parameter of that name.
inline const std::string kLightPathsPerPixel = "light-paths-per-pixel";
ParameterSpec light_paths_parameter(double default_value, std::string help);
ParameterSpec heuristic_parameter();
/// Choice between roulette by efficiency and by throughput alone.
ParameterSpec roulette_parameter(std::string default_value);
ParameterSpec roulette_start_parameter(int default_value);

/// By the parameter of that name.
Heuristic heuristic_of(const Parameters& parameters);

}  // namespace ajar
