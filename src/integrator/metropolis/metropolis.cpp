#include "integrator/metropolis/metropolis.h"

#include <memory>
#include <utility>

#include "integrator/metropolis/chain_integrator.h"
#include "integrator/metropolis/mmlt_extensions.h"
#include "integrator/metropolis/primary_space.h"
#include "integrator/montecarlo/path_parameters.h"

namespace ajar {

std::vector<ParameterSpec> metropolis_parameters(ChainSpace kind) {
  std::vector<ParameterSpec> specs = {techniques_parameter("bdpt"), heuristic_parameter()};
  specs.back().expert = true;
  for (ParameterSpec& spec : ChainMoves::parameters({})) specs.push_back(std::move(spec));
  if (kind == ChainSpace::Mmlt) add_mmlt_extensions(specs);
  specs.push_back(bootstrap_parameter());
  specs.push_back(chains_parameter());
  if (kind == ChainSpace::Pssmlt) {
    specs.push_back(roulette_start_parameter(3));
    specs.back().expert = true;
  }
  return specs;
}

std::unique_ptr<Integrator> make_metropolis_integrator(ChainSpace kind, const Scene& scene,
                                                       const RenderSettings& settings,
                                                       const Parameters& parameters,
                                                       const ChainWeight* part) {
  ChainOrder order = chain_order(settings, parameters,
                                 {{"techniques", parameters.get_text("techniques")},
                                  {"heuristic", parameters.get_text("heuristic")}});
  order.groups =
      make_path_groups(scene, kind, order.sampler,
                       kind == ChainSpace::Pssmlt ? parameters.get_int("roulette-start") : 0);
  order.part = part;
  const auto chains = static_cast<std::size_t>(parameters.get_int("chains"));
  PrimarySpace space(kind == ChainSpace::Mmlt ? mmlt_moves(parameters) : ChainMoves(parameters));
  return std::make_unique<ChainIntegrator<PrimarySpace>>(scene, settings, std::move(order), chains,
                                                         std::move(space));
}

}  // namespace ajar
