#include "integrator/metropolis/chain_integrator.h"

namespace ajar {

namespace {
/// pbrt's default, over all depths and replicates.
constexpr const char* kChains = "1000";
}  // namespace

ParameterSpec chains_parameter() {
  return {.name = "chains",
          .type = ParameterType::Int,
          .default_value = kChains,
          .unit = "",
          .help = "number of Markov chains",
          .choices = {},
          .minimum = 1,
          .maximum = 1000000};
}

}  // namespace ajar
