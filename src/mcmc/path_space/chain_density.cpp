#include "mcmc/path_space/chain_density.h"

#include <cmath>
#include <vector>

#include "mcmc/path_space/path_mutation.h"

namespace ajar {

double log_chain_density(const Scene& scene, const Path& path, int fixed, int moved,
                         std::span<const OffsetNormal> offsets) {
  std::vector<InnerVertex> chain;
  for (int x = moved - 1; x > fixed; --x) chain.push_back(path.vertex(x));
  SpecularChain linear(scene);
  if (!linear.set(chain_end(path, moved), chain, chain_end(path, fixed), offsets)) return kNever;
  const double spread = linear.spread();
  if (!(spread > 0.0) || !std::isfinite(spread)) return kNever;
  double sum = -std::log(spread);
  for (int x = moved; x > fixed + 1; --x) {
    const Vec3 w = path.toward_light(scene, x);
    sum += std::log(double{path.vertex(x - 1).cosine(w)} / path.squared_distance(x, x - 1));
  }
  // The cosine there is in both, or in none.
  if (!chain_end(path, fixed).at_infinity) {
    sum -= std::log(path.squared_distance(fixed + 1, fixed));
  }
  return sum;
}

}  // namespace ajar
