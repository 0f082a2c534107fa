#include "integrator/metropolis/path_seeds.h"

#include <bit>
#include <cmath>
#include <limits>

#include "core/random_use.h"
#include "mcmc/path_space/path_form.h"
#include "mcmc/path_space/path_kernel.h"
#include "mcmc/primary/bootstrap_source.h"

namespace ajar {

// ---------------------------------------------------------------- PathPicker

void PathSeeds::PathPicker::begin_sample(const Vec2& raster, std::uint64_t key,
                                         std::optional<double> place) {
  begin(raster);
  key_ = key;
  total = 0.0;
  chosen.reset();
  place_ = place;
}

bool PathSeeds::PathPicker::reaches(const Vec2& raster) const {
  return seeds_.view_.contains(raster);
}

double PathSeeds::PathPicker::brings(const Contribution& contribution) const {
  const Vec2& raster = contribution.technique.t == 1 ? contribution.raster : this->raster();
  auto brings =
      static_cast<double>(luminance(contribution.value) * seeds_.view_.importance(raster));
  if (seeds_.part_ != nullptr) {
    brings *= static_cast<double>(seeds_.part_->weight(contribution, raster));
  }
  if (contribution.technique.t == 1) brings /= seeds_.view_.area_per_pixel();
  return brings;
}

bool PathSeeds::PathPicker::wants(const Contribution& contribution) {
  if (!has_paths(seeds_.group_.paths, contribution.unidirectional_only)) return false;
  if (chooses()) return !has_chosen();
  // One lane below zero must not hide behind the others.
  if (contribution.value.min() < 0.F) total = std::numeric_limits<double>::quiet_NaN();
  if (contribution.unidirectional_only && seeds_.by_manifolds_) return true;
  total += brings(contribution);
  return false;
}

void PathSeeds::PathPicker::record(const Path& path, const Contribution& contribution) {
  double brought = brings(contribution);
  if (contribution.unidirectional_only && seeds_.by_manifolds_) {
    brought *= seeds_.manifolds_.hit_share(
        path,
        hash_numbers(key_, RandomUse::ManifoldSeed, static_cast<std::uint64_t>(path.depth())));
  }
  add_path(path, brought);
}

void PathSeeds::PathPicker::add_path(const Path& path, double brings) {
  if (has_chosen() || !(brings > 0.0) || !std::isfinite(brings)) return;
  if (chooses()) {
    if (!std::isfinite(seeds_.log_light(path))) return;
    chosen = path;
  }
  total += brings;
}

// ---------------------------------------------------------------- PathSeeds

PathSeeds::PathSeeds(const Scene& scene, const PathGroup& group, const ChainView& view,
                     const ChainWeight* part, double manifold_tries)
    : scene_(scene),
      group_(group),
      view_(view),
      part_(part),
      manifold_tries_(manifold_tries),
      share_(scene, group.sampler, view.importance, part, group.paths),
      sampler_(scene, group.sampler),
      bounds_(bounds_of(group, view)),
      manifolds_(scene, *group.photons, bounds_, manifold_tries),
      by_manifolds_(has_manifolds(group)),
      picker_(*this) {}

double PathSeeds::log_light(const Path& path) {
  splats_.clear();
  return light_on(scene_, path, bounds_, 0, splats_, &share_);
}

void PathSeeds::sample(SampleSource& numbers, std::optional<double> place) {
  const Vec2 raster = view_.raster(numbers.get_pair({Stream::Camera, 0, kEmissionDirection}));
  const Vec2 bits = numbers.get_pair({Stream::Connection, 0, Slot::LightPositionX});
  const std::uint64_t key =
      hash_numbers(std::bit_cast<std::uint32_t>(bits.x), RandomUse::ManifoldSeed,
                   std::bit_cast<std::uint32_t>(bits.y));
  picker_.begin_sample(raster, key, place);
  if (traces_light_alone(group_.sampler)) sampler_.sample_light(numbers, picker_);
  sampler_.sample(numbers, raster, picker_);
  const float u = numbers.get({Stream::Connection, 0, Slot::Roulette});
  if (by_manifolds_ && !picker_.has_chosen() && double{u} < manifold_tries_) {
    add_manifolds(key);
  }
  count_rays();
}

void PathSeeds::count_rays() {
  rays_ = sampler_.ray_counts();
  rays_.add_rays(manifolds_.ray_counts());
}

std::span<const ManifoldSeeds::Seed> PathSeeds::try_manifolds(std::uint64_t key) {
  BootstrapSource numbers(key, 0);
  const Vec2 raster = view_.raster(numbers.get_pair({Stream::Camera, 0, kEmissionDirection}));
  return manifolds_.sample(numbers, raster, key);
}

void PathSeeds::add_manifolds(std::uint64_t key) {
  const auto seeds = try_manifolds(key);
  for (const ManifoldSeeds::Seed& seed : seeds) {
    double brings = std::exp(log_light(seed.path) + seed.log_factor) / manifold_tries_;
    if (!(brings > 0.0)) continue;
    // The last one is chosen if none was before, whatever it brings: to find that out anew may take
    // long.
    const bool is_last = &seed == &seeds.back();
    if (!picker_.chooses() || !is_last) brings *= manifolds_.inverse_chance(seed);
    picker_.add_path(seed.path, brings);
  }
}

std::vector<PathSeeds::Joined> PathSeeds::join_by_manifolds(std::uint64_t key) {
  std::vector<Joined> joined;
  for (const ManifoldSeeds::Seed& seed : try_manifolds(key)) {
    double brings = std::exp(log_light(seed.path) + seed.log_factor);
    if (brings > 0.0) brings *= manifolds_.inverse_chance(seed);
    if (brings > 0.0 && std::isfinite(brings)) joined.push_back({seed.path, brings});
  }
  count_rays();
  return joined;
}

double PathSeeds::evaluate(SampleSource& numbers, const Change& /*change*/,
                           SplatBuffer& /*splats*/) {
  sample(numbers, std::nullopt);
  return picker_.total;
}

std::optional<Path> PathSeeds::choose(SampleSource& numbers, double total, double u) {
  sample(numbers, u * total);
  return std::move(picker_.chosen);
}

std::optional<Path> choose_path(const Scene& scene, const PathGroup& group, const ChainView& view,
                                const SampleOfChains& sample, std::uint64_t number,
                                const ChainWeight* part) {
  BootstrapSource numbers(sample.seed, sample.index);
  const double u =
      to_unit_double(hash_numbers(sample.seed, RandomUse::PathSeed, sample.index, number));
  return PathSeeds(scene, group, view, part).choose(numbers, sample.weight, u);
}

}  // namespace ajar
