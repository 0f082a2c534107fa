#include "integrator/metropolis/mlt.h"

#include <utility>

#include "integrator/metropolis/chain_integrator.h"
#include "integrator/metropolis/path_space.h"
#include "integrator/montecarlo/path_parameters.h"

namespace ajar {

std::vector<ParameterSpec> mlt_parameters() {
  std::vector<ParameterSpec> specs = path_mutation_parameters();
  specs.push_back(bootstrap_parameter());
  specs.push_back(chains_parameter());
  specs.push_back(roulette_start_parameter(3));
  specs.back().expert = true;
  return specs;
}

std::unique_ptr<Integrator> make_mlt_integrator(const Scene& scene, const RenderSettings& settings,
                                                const Parameters& parameters,
                                                const ChainWeight* part) {
  ChainOrder order = chain_order(settings, parameters, {{"techniques", "bdpt"}});
  order.groups = make_path_groups(scene, ChainSpace::Paths, order.sampler,
                                  parameters.get_int("roulette-start"));
  if (parameters.get_float("bidirectional") == 0.0) {
    order.notes = {
        "without bidirectional mutations chains stay at paths of one length, and at mirrors and "
        "clear glass that seeds have found: how much light each of these has is what the bootstrap "
        "says, however long chains run"};
  }
  order.part = part;
  const auto chains = static_cast<std::size_t>(parameters.get_int("chains"));
  return std::make_unique<ChainIntegrator<PathSpace>>(scene, settings, std::move(order), chains,
                                                      PathSpace(parameters));
}

}  // namespace ajar
