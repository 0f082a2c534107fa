#include "integrator/metropolis/divided_path_weight.h"

#include <algorithm>
#include <limits>

#include "mcmc/path_space/manifold_seeds.h"
#include "mcmc/path_space/path_form.h"

namespace ajar {

double DividedPathWeight::part(const Path& path, double log_light) {
  if (!has_paths(paths_, is_hit_only(path))) return 0.0;
  if (no_technique_makes(path)) {
    return makes_hits_ && ManifoldSeeds::finds(scene_, path) ? 1.0 : 0.0;
  }
  constexpr auto kMost = static_cast<double>(std::numeric_limits<float>::max());
  double sum = 0.0;
  int s = 0;
  for (const TechniqueParts::Part& own : parts_.of(path, log_light)) {
    const Technique technique{s, path.depth() + 1 - s};
    ++s;
    if (own.weight == 0.0) continue;
    const auto light = static_cast<float>(std::min(own.light, kMost));
    const float weight = part_ != nullptr ? part_->weight(technique, light, path.raster) : 1.F;
    sum += own.weight * static_cast<double>(weight);
  }
  return sum;
}

}  // namespace ajar
