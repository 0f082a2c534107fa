#include "mcmc/path_space/multi_chain_perturbation.h"

#include "mcmc/path_space/path_form.h"

namespace ajar {

std::optional<int> MultiChainPerturbation::end_of(const Path& path) const {
  const int first = first_rough_from_camera(path);
  if (first == 0 || can_join(path, first)) return std::nullopt;
  int x = first - 1;
  while (x > 0 && !can_join(path, x)) --x;
  return x > 0 ? x : end_at_light(path);
}

}  // namespace ajar
