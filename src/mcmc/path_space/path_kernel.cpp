#include "mcmc/path_space/path_kernel.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "core/random_use.h"
#include "mcmc/counter_random.h"
#include "path/measure.h"
#include "path/verify.h"

namespace ajar {

double light_on(const Scene& scene, const Path& path, const PathBounds& bounds, std::int32_t layer,
                SplatBuffer& splats, PathWeight* weight) {
  constexpr double kDark = -std::numeric_limits<double>::infinity();
  if (!bounds.area.contains(path.raster)) return kDark;
  if (!bounds.counted.holds(path.counted_depth()) || is_hidden(scene, path)) return kDark;
  const ScaledSpectrum f = contribution(scene, path);
  if (f.spectrum.min() < 0.F) return std::numeric_limits<double>::quiet_NaN();
  double light = f.log_luminance();
  float importance = 1.F;
  if (weight != nullptr && std::isfinite(light)) {
    const double part = weight->part(path, light);
    importance = weight->importance(path.raster);
    light += std::log(part * static_cast<double>(importance));
  }
  if (std::isfinite(light)) {
    splats.push_back({path.raster, layer, f.spectrum / (luminance(f.spectrum) * importance)});
  }
  return light;
}

PathKernel::PathKernel(const Scene& scene, const PathBounds& bounds,
                       std::vector<MixedMutation> mutations, std::int32_t (*layer)(int depth),
                       PathWeight* weight)
    : scene_(scene),
      bounds_(bounds),
      mutations_(std::move(mutations)),
      layer_(layer),
      weight_(weight) {
  for (const MixedMutation& mixed : mutations_) moves_.push_back({mixed.mutation->name(), false});
}

double PathKernel::suitable_weight(const Path& path) const {
  double weight = 0.0;
  for (const MixedMutation& mixed : mutations_) {
    if (mixed.weight > 0.0 && mixed.mutation->suitable(path)) weight += mixed.weight;
  }
  return weight;
}

void PathKernel::start(PathChain& chain) {
  chain_ = &chain;
  splats_.clear();
  const Path& path = chain.path;
  current_.log_light = light_on(scene_, path, bounds_, layer_(path.depth()), splats_, weight_);
  current_.weight = suitable_weight(path);
  if (!std::isfinite(current_.log_light)) {
    throw std::logic_error("bug: the path of a Markov chain is dark. To replay: seed " +
                           std::to_string(chain.seed) + ", origin " + std::to_string(chain.origin) +
                           ", " + std::to_string(chain.step) + " steps");
  }
}

Proposal PathKernel::propose(std::uint64_t key) {
  candidate_.splats.clear();
  candidate_.take(0.0);
  candidate_.probability = 0.0;
  without_density_ = false;
  PathMutation* const mutation = choose(key);
  if (mutation == nullptr) return {move_, {&candidate_, 1}};
  const std::uint64_t rays_before = mutation->ray_counts().rays;
  consider(*mutation, key);
  return {move_,
          {&candidate_, 1},
          mutation->ray_counts().rays - rays_before,
          mutation->walk_end(),
          without_density_};
}

PathMutation* PathKernel::choose(std::uint64_t key) {
  const Path& x = chain_->path;
  double left =
      to_unit_double(counter_bits(hash_numbers(key, RandomUse::PathMutation), 0)) * current_.weight;
  PathMutation* chosen = nullptr;
  move_.reset();
  for (std::size_t i = 0; i < mutations_.size(); ++i) {
    const MixedMutation& mixed = mutations_[i];
    if (!(mixed.weight > 0.0) || !mixed.mutation->suitable(x)) continue;
    chosen = mixed.mutation.get();
    move_ = i;
    if (left < mixed.weight) break;
    left -= mixed.weight;
  }
  return chosen;
}

void PathKernel::consider(PathMutation& mutation, std::uint64_t key) {
  const Path& x = chain_->path;
  const auto kept = mutation.propose(x, hash_numbers(key, RandomUse::PathNumbers), path_);
  if (!kept) return;
#ifndef NDEBUG
  verify(scene_, path_, mutation.name());
#endif
  proposed_.log_light =
      light_on(scene_, path_, bounds_, layer_(path_.depth()), candidate_.splats, weight_);
  if (!std::isfinite(proposed_.log_light)) {
    // NaN is passed on, as chains count it.
    if (proposed_.log_light != -std::numeric_limits<double>::infinity()) {
      candidate_.take(proposed_.log_light);
    }
    return;
  }
  candidate_.take(1.0);
  if (!mutation.suitable(path_)) return;
  proposed_.weight = suitable_weight(path_);
  const double forth = mutation.log_density(x, path_, *kept);
  const double back = mutation.log_density(path_, x, *kept);
  // Asked from the other path it is the same pair, so both ways are refused.
  without_density_ = !std::isfinite(forth) || !(back < std::numeric_limits<double>::infinity());
  if (without_density_) return;
  const double log_ratio = proposed_.log_light - current_.log_light + back - forth +
                           std::log(current_.weight / proposed_.weight);
  candidate_.probability = metropolis_hastings(1.0, 1.0, log_ratio);
}

void PathKernel::accept(std::size_t /*candidate*/) {
  std::swap(chain_->path, path_);
  current_ = proposed_;
  std::swap(splats_, candidate_.splats);
}

RayCounts PathKernel::ray_counts() const {
  RayCounts rays;
  for (const MixedMutation& mixed : mutations_) rays.add_rays(mixed.mutation->ray_counts());
  return rays;
}

}  // namespace ajar
