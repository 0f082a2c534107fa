#include "mcmc/path_space/manifold_perturbation.h"

#include "mcmc/path_space/path_form.h"

namespace ajar {

std::optional<ConstraintPerturbation::Span> ManifoldPerturbation::span_of(const Path& path) const {
  const int moved = first_rough_from_camera(path);
  int fixed = moved - 1;
  while (fixed > 0 && path.vertex(fixed).event.specular()) --fixed;
  if (fixed < 0 || fixed == moved - 1) return std::nullopt;
  return Span{fixed, moved};
}

}  // namespace ajar
