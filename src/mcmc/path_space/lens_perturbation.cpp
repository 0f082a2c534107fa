#include "mcmc/path_space/lens_perturbation.h"

#include "mcmc/path_space/path_form.h"

namespace ajar {

std::optional<int> LensPerturbation::end_of(const Path& path) const {
  const int rough = first_rough_from_camera(path);
  if (rough == 0) return end_at_light(path);
  return can_join(path, rough) ? std::optional(rough) : std::nullopt;
}

}  // namespace ajar
