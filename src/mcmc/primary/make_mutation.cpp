#include "mcmc/primary/make_mutation.h"

#include <array>

#include "core/error.h"
#include "mcmc/primary/gaussian_mutation.h"
#include "mcmc/primary/kelemen_mutation.h"

namespace ajar {

std::span<const std::string> mutation_names() {
  static const std::array<std::string, 2> names{"gaussian", "kelemen"};
  return names;
}

std::unique_ptr<Mutation> make_mutation(std::string_view name, double sigma) {
  if (name == "gaussian") return std::make_unique<GaussianMutation>(sigma);
  if (name == "kelemen") return std::make_unique<KelemenMutation>();
  throw UsageError(unknown_name_message("mutation", name, mutation_names()));
}

}  // namespace ajar
