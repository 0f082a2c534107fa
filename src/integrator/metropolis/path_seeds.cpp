#include "integrator/metropolis/path_seeds.h"

#include <bit>
#include <cmath>

#include "core/random_use.h"
#include "integrator/metropolis/heuristics.h"
#include "mcmc/path_space/path_form.h"
#include "mcmc/path_space/path_kernel.h"
#include "mcmc/primary/bootstrap_source.h"

namespace ajar {

// ---------------------------------------------------------------- Lot

void PathSeeds::Lot::begin_sample(const Vec2& raster, std::optional<double> u) {
  begin(raster);
  total = 0.0;
  chosen.reset();
  u_ = u;
}

bool PathSeeds::Lot::reaches(const Vec2& raster) const { return seeds_.view_.contains(raster); }

double PathSeeds::Lot::brings(const Contribution& contribution) const {
  const Vec2& raster = contribution.technique.t == 1 ? contribution.raster : this->raster();
  auto brings =
      static_cast<double>(luminance(contribution.value) * seeds_.view_.importance(raster));
  if (seeds_.part_ != nullptr) {
    brings *= static_cast<double>(seeds_.part_->share(contribution, raster));
  }
  if (contribution.technique.t == 1) brings /= seeds_.view_.area_per_pixel();
  return brings;
}

bool PathSeeds::Lot::wants(const Contribution& contribution) {
  if (!has_paths(seeds_.group_.paths, contribution.hit_only)) return false;
  if (u_ || (contribution.hit_only && seeds_.by_manifolds_)) return true;
  total += brings(contribution);
  return false;
}

void PathSeeds::Lot::record(const Path& path, const Contribution& contribution) {
  double brought = brings(contribution);
  if (contribution.hit_only && seeds_.by_manifolds_) {
    brought *= ManifoldSeeds::hit_share(scene(), path);
  }
  add_path(path, brought);
}

void PathSeeds::Lot::add_path(const Path& path, double brings) {
  if (!(brings > 0.0) || !std::isfinite(brings)) return;
  if (u_ && !std::isfinite(seeds_.log_light(path))) return;
  total += brings;
  if (!u_) return;
  // The number that is left of u is uniform again, whichever way this goes.
  const double share = brings / total;
  if (*u_ < share) {
    chosen = path;
    *u_ /= share;
  } else {
    *u_ = (*u_ - share) / (1.0 - share);
  }
}

// ---------------------------------------------------------------- PathSeeds

PathSeeds::PathSeeds(const Scene& scene, const PathGroup& group, const ChainView& view,
                     const PathPart* part)
    : scene_(scene),
      group_(group),
      view_(view),
      part_(part),
      share_(scene, group.sampler, view.importance, part, group.paths),
      sampler_(scene, group.sampler),
      bounds_{view, group.sampler.min_depth, group.sampler.max_depth},
      manifolds_(scene, *group.photons, bounds_),
      by_manifolds_(has_paths(group.paths, true) &&
                    group.sampler.techniques.any(TechniqueClass::Implicit)),
      lot_(*this) {}

double PathSeeds::log_light(const Path& path) {
  splats_.clear();
  return light_on(scene_, path, view_, 0, splats_, &share_);
}

void PathSeeds::sample(SampleSource& numbers, std::optional<double> u) {
  const Vec2 raster = view_.raster(numbers.get_pair({Stream::Camera, 0, kEmissionDirection}));
  lot_.begin_sample(raster, u);
  if (traces_light_alone(group_.sampler)) sampler_.sample_light(numbers, lot_);
  sampler_.sample(numbers, raster, lot_);
  const float lot = numbers.get({Stream::Connection, 0, Slot::Roulette});
  if (by_manifolds_ && lot < MetropolisHeuristics::kManifoldTries) {
    const Vec2 bits = numbers.get_pair({Stream::Connection, 0, Slot::LightPositionX});
    join_by_manifolds(hash_numbers(std::bit_cast<std::uint32_t>(bits.x), RandomUse::ManifoldSeed,
                                   std::bit_cast<std::uint32_t>(bits.y)));
  }
  rays_ = sampler_.ray_counts();
  rays_.add_rays(manifolds_.ray_counts());
}

void PathSeeds::join_by_manifolds(std::uint64_t key) {
  BootstrapSource numbers(key, 0);
  const Vec2 raster = view_.raster(numbers.get_pair({Stream::Camera, 0, kEmissionDirection}));
  for (const ManifoldSeeds::Seed& seed : manifolds_.sample(numbers, raster, key)) {
    const double brings = std::exp(log_light(seed.path) + seed.log_factor) /
                          double{MetropolisHeuristics::kManifoldTries};
    if (brings > 0.0) lot_.add_path(seed.path, brings * manifolds_.inverse_chance(seed));
  }
}

double PathSeeds::evaluate(SampleSource& numbers, const Change& /*change*/,
                           SplatBuffer& /*splats*/) {
  sample(numbers, std::nullopt);
  return lot_.total;
}

std::optional<Path> PathSeeds::choose(SampleSource& numbers, double u) {
  sample(numbers, u);
  return std::move(lot_.chosen);
}

std::optional<Path> choose_path(const Scene& scene, const PathGroup& group, const ChainView& view,
                                std::uint64_t seed, std::uint64_t index, double u,
                                const PathPart* part) {
  BootstrapSource numbers(seed, index);
  return PathSeeds(scene, group, view, part).choose(numbers, u);
}

}  // namespace ajar
