#include "support/selective.h"

#include <nlohmann/json.hpp>

namespace ajar::test {

RenderOptions selective_options(std::uint64_t samples) {
  RenderOptions options;
  options.integrator = "selective";
  options.samples = samples;
  options.replicates = 4;
  return options;
}

Render prepared_render(const Scene& scene, std::uint64_t seed,
                       const std::map<std::string, std::string>& parameters) {
  RenderOptions options = selective_options(4);
  options.max_depth = 8;
  options.seed = seed;
  options.parameters = parameters;
  return render(scene, options);
}

MethodReport report_of(const Scene& scene, std::uint64_t seed,
                       const std::map<std::string, std::string>& parameters) {
  return prepared_render(scene, seed, parameters).integrator->report().at("selective");
}

}  // namespace ajar::test
