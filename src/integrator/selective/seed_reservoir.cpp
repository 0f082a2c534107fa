#include "integrator/selective/seed_reservoir.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <stdexcept>
#include <tuple>

#include "core/parallel_for.h"
#include "core/random.h"
#include "core/random_use.h"
#include "integrator/metropolis/path_seeds.h"
#include "integrator/montecarlo/path_family.h"
#include "integrator/selective/chain_archive.h"
#include "integrator/selective/chain_starts.h"
#include "integrator/selective/heuristics.h"
#include "mcmc/bootstrap.h"
#include "mcmc/counter_random.h"

namespace ajar {

namespace {

/// Paths of one technique lie side by side, so that systematic resampling spreads chains evenly
/// over them. The key makes the order unique.
auto order_of(const OutlierPath& path) {
  return std::tuple(path.technique.depth(), path.technique.s, path.key());
}

/// Samples of one replicate among the samples `first` to `last` of a pixel.
std::uint64_t samples_of(std::uint64_t replicate, std::uint64_t replicates, std::uint64_t first,
                         std::uint64_t last) {
  const auto upto = [&](std::uint64_t n) {
    return n / replicates + (n % replicates > replicate ? 1 : 0);
  };
  return upto(last) - upto(first);
}

}  // namespace

class SeedReservoir::Sink final : public OutlierSink {
 public:
  Sink(const SeedReservoir& reservoir, Counters& counters)
      : reservoir_(reservoir), counters_(counters) {}

  double threshold() const override { return reservoir_.threshold_; }
  bool spread(SampleSource& numbers, OutlierPath& path) override {
    SeedPath seed{path, PathNumbers(numbers, path), {}};
    const auto chain =
        start_chain_of(reservoir_.prepared_, seed.numbers, path, std::nullopt, counters_);
    seed.scalar = chain ? chain->chain().scalar : 0.0;
    // Rounding may have moved the path off an edge.
    if (!(*seed.scalar > 0.0 && std::isfinite(*seed.scalar))) return false;
    reservoir_.share_with_manifolds(seed, *chain, counters_);
    if (seed.path.energy != 0.0) reservoir_.keep(std::move(seed));
    return true;
  }

 private:
  const SeedReservoir& reservoir_;
  Counters& counters_;
};

double SeedReservoir::evaluate(const SeedPath& seed, RayCounts& rays) const {
  const auto chain = start_chain_of(prepared_, seed.numbers, seed.path, std::nullopt, rays);
  return chain ? chain->chain().scalar : 0.0;
}

void SeedReservoir::share_with_manifolds(SeedPath& seed, const SelectiveChain& chain,
                                         RayCounts& rays) const {
  const PathGroup& group = prepared_.group_of(seed.path);
  if (!seed.path.unidirectional_only || !PathSeeds::has_manifolds(group)) return;
  ManifoldSeeds manifolds(prepared_.scene(), *group.photons, bounds_of(group, prepared_.view),
                          SelectiveHeuristics::kManifoldTries);
  seed.path.energy *= manifolds.hit_share(std::get<PathChain>(chain.state).path,
                                          hash_numbers(seed.path.key(), RandomUse::ManifoldSeed));
  rays.add_rays(manifolds.ray_counts());
}

std::unique_ptr<OutlierSink> SeedReservoir::make(Film& /*film*/, Counters& counters) const {
  return std::make_unique<Sink>(*this, counters);
}

void SeedReservoir::keep(SeedPath seed) const {
  const std::lock_guard lock(mutex_);
  seeds_.push_back(std::move(seed));
}

void SeedReservoir::load_seeds(InputArchive& archive, std::vector<SeedPath>& seeds) const {
  std::uint64_t count = 0;
  archive(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    SeedPath& seed = seeds.emplace_back();
    archive(seed);
    const int replicate = seed.path.replicate;
    if (!seed.numbers.fit(seed.path) || replicate < 0 ||
        replicate >= prepared_.config.settings.replicates) {
      throw std::runtime_error("corrupt checkpoint: a seed path does not fit the render");
    }
  }
}

void SeedReservoir::check_seed(const SeedPath& seed) const {
  const OutlierPath& path = seed.path;
  const TechniqueChoice& choice = prepared_.group_of(path.technique.depth()).choice;
  bool known = false;
  for (std::size_t i = 0; i < choice.size(); ++i) known = known || choice[i] == path.technique;
  if (!known || !prepared_.view.contains(path.raster) || !std::isfinite(path.energy)) {
    throw std::runtime_error("corrupt checkpoint: invalid seed path");
  }
  // A chain that starts there must have what `ChainRunner` sees there.
  RayCounts rays;
  const double scalar = evaluate(seed, rays);
  if (!(scalar > 0.0 && std::isnormal(scalar)) || (seed.scalar && *seed.scalar != scalar)) {
    throw std::runtime_error("corrupt checkpoint: a seed path is not what it was");
  }
}

void SeedReservoir::save_state(OutputArchive& archive) const {
  archive(threshold_, static_cast<std::uint64_t>(seeds_.size() + shared_.size()));
  for (const SeedPath& seed : shared_) archive(seed);
  for (const SeedPath& seed : seeds_) archive(seed);
}

void SeedReservoir::load_state(InputArchive& archive) {
  manifolds_.clear();
  seeds_.clear();
  shared_.clear();
  archive(threshold_);
  if (!(threshold_ >= 0.0 && std::isfinite(threshold_))) {
    throw std::runtime_error("corrupt checkpoint: invalid threshold of seed paths");
  }
  load_seeds(archive, shared_);
  parallel_for(shared_.size(), [&](std::size_t i) { check_seed(shared_[i]); });
  // All of them share b.
  if (!std::isfinite(energy()))
    throw std::runtime_error("corrupt checkpoint: seed paths are too bright");
}

void SeedReservoir::export_delta(OutputArchive& archive) {
  archive(static_cast<std::uint64_t>(seeds_.size()));
  for (const SeedPath& seed : seeds_) archive(seed);
  seeds_.clear();
}

void SeedReservoir::import_delta(InputArchive& archive) { load_seeds(archive, shared_); }

void SeedReservoir::set_threshold(double per_sample, double camera_samples) {
  const double whole = per_sample * camera_samples * static_cast<double>(prepared_.pixels()) /
                       prepared_.config.settings.replicates;
  threshold_ = whole / static_cast<double>(prepared_.chains_per_replicate());
}

void SeedReservoir::set_initial_rate(double camera_samples) {
  set_threshold(prepared_.brightness, camera_samples);
}

void SeedReservoir::set_rate(const std::vector<ChainPopulation>& populations,
                             double camera_samples) {
  double b = 0.0;
  for (const ChainPopulation& population : populations) b += population.b.total;
  set_threshold(std::max(b / prepared_.config.settings.replicates * prepared_.view.area_per_pixel(),
                         SelectiveHeuristics::kLeastShareOfChains * prepared_.brightness),
                camera_samples);
}

double SeedReservoir::energy() const {
  // In an order that does not depend on threads.
  std::vector<double> energies;
  const auto add = [&](const SeedPath& seed) { energies.push_back(std::abs(seed.path.energy)); };
  std::for_each(seeds_.begin(), seeds_.end(), add);
  std::for_each(shared_.begin(), shared_.end(), add);
  std::sort(energies.begin(), energies.end());
  return std::accumulate(energies.begin(), energies.end(), 0.0);
}

void SeedReservoir::divide_anew(const Divisions& before) {
  for (SeedPath& seed : seeds_) {
    OutlierPath& path = seed.path;
    const auto share_of = [&](const Divisions& divisions) {
      return divisions.of(path.replicate).chain_fraction(path.strength, path.raster);
    };
    const float change = share_of(*prepared_.divisions) / share_of(before);
    path.value *= change;
    path.energy *= static_cast<double>(change);
    if (change != 1.F) seed.scalar.reset();
  }
  std::erase_if(seeds_, [](const SeedPath& seed) { return seed.path.energy == 0.0; });
}

std::vector<SeedReservoir::Found> SeedReservoir::sorted_finds(
    const std::vector<ChainPopulation>& populations) {
  std::move(shared_.begin(), shared_.end(), std::back_inserter(seeds_));
  shared_.clear();
  std::sort(seeds_.begin(), seeds_.end(), [](const SeedPath& a, const SeedPath& b) {
    return order_of(a.path) < order_of(b.path);
  });
  std::map<std::pair<int, const PathGroup*>, std::size_t> by_replicate_and_group;
  for (std::size_t p = 0; p < populations.size(); ++p) {
    by_replicate_and_group[{populations[p].replicate, &prepared_.groups()[populations[p].group]}] =
        p;
  }
  std::vector<Found> found(populations.size());
  for (const SeedPath& seed : seeds_) {
    const OutlierPath& path = seed.path;
    found[by_replicate_and_group.at({path.replicate, &prepared_.group_of(path)})].paths.push_back(
        &seed);
  }
  return found;
}

std::vector<SampleRange> SeedReservoir::ranges(std::uint64_t first, std::uint64_t last) const {
  const auto replicates = static_cast<std::uint64_t>(prepared_.config.settings.replicates);
  std::vector<SampleRange> all;
  for (std::uint64_t replicate = 0; replicate < replicates; ++replicate) {
    const std::uint64_t samples =
        samples_of(replicate, replicates, first, last) * prepared_.pixels();
    all.push_back({static_cast<double>(samples), last});
  }
  return all;
}

void SeedReservoir::advance(const std::vector<ChainPopulation>& populations, std::uint64_t first,
                            std::uint64_t now, std::uint64_t last) {
  if (now <= first) return;
  manifolds_.advance(populations, ranges(first, last),
                     static_cast<double>(now - first) / static_cast<double>(last - first));
}

void SeedReservoir::merge(std::vector<ChainPopulation>& populations, std::uint64_t first,
                          std::uint64_t last) {
  merge_all(populations, ranges(first, last));
}

void SeedReservoir::merge_unassigned(std::vector<ChainPopulation>& populations,
                                     double camera_samples) {
  const int replicates = prepared_.config.settings.replicates;
  for (SeedPath& seed : seeds_) {
    seed.path.replicate = static_cast<int>(hash_numbers(seed.path.key(), RandomUse::SeedReplicate) %
                                           static_cast<std::uint64_t>(replicates));
  }
  merge_all(populations, std::vector<SampleRange>(static_cast<std::size_t>(replicates),
                                                  {camera_samples / replicates, 0}));
}

void SeedReservoir::merge_all(std::vector<ChainPopulation>& populations,
                              const std::vector<SampleRange>& ranges) {
  auto found = sorted_finds(populations);
  manifolds_.advance(populations, ranges, 1.0);
  for (std::size_t p = 0; p < populations.size(); ++p) found[p].joined = manifolds_.take(p);
  manifolds_.clear();
  for (std::size_t replicate = 0; replicate < ranges.size(); ++replicate) {
    merge_replicate(populations, found, static_cast<int>(replicate), ranges[replicate]);
  }
  seeds_.clear();
}

void SeedReservoir::merge_replicate(std::vector<ChainPopulation>& populations,
                                    const std::vector<Found>& found, int replicate,
                                    const SampleRange& range) const {
  if (range.samples == 0.0) return;
  std::vector<std::size_t> own;
  std::vector<double> b;
  for (std::size_t p = 0; p < populations.size(); ++p) {
    if (populations[p].replicate != replicate) continue;
    own.push_back(p);
    add_mass(populations[p], found[p], range.samples);
    b.push_back(populations[p].b.total);
  }
  const std::vector<std::size_t> shares = apportion(b, prepared_.chains_per_replicate());
  for (std::size_t i = 0; i < own.size(); ++i) {
    resample(populations[own[i]], found[own[i]], shares[i], range.number);
  }
}

void SeedReservoir::add_mass(ChainPopulation& population, const Found& found,
                             double samples) const {
  const double before = population.samples_behind;
  const double share = samples / (before + samples);
  const double scale = share / samples / prepared_.view.area_per_pixel();
  ChainPopulation::Brightness b{.per_seed = scale};
  const auto add = [&](double energy) {
    const double mass = std::abs(energy) * scale;
    b.total += mass;
    b.variance += mass * mass;
  };
  for (const SeedPath* seed : found.paths) add(seed->path.energy);
  for (const ManifoldSeedPath& path : found.joined) add(path.energy);
  b.of_chains = (1.0 - share) * population.b.total;
  b.total += b.of_chains;
  b.variance += (1.0 - share) * (1.0 - share) * population.b.variance;
  population.b = b;
  population.samples_behind = before + samples;
}

std::optional<SelectiveChain> SeedReservoir::start(const Found& found, std::size_t number,
                                                   RayCounts& rays) const {
  if (number < found.paths.size()) {
    const SeedPath& seed = *found.paths[number];
    return start_chain_of(prepared_, seed.numbers, seed.path, seed.scalar, rays);
  }
  const ManifoldSeedPath& joined = found.joined[number - found.paths.size()];
  return start_chain_at(joined.path, joined.key);
}

void SeedReservoir::resample(ChainPopulation& population, const Found& found, std::size_t chains,
                             std::uint64_t epoch) const {
  std::vector<SelectiveChain> old = std::move(population.chains);
  population.chains.clear();
  std::vector<double> masses;
  masses.reserve(old.size() + found.paths.size() + found.joined.size());
  double of_old = 0.0;
  for (const SelectiveChain& member : old) of_old += std::abs(member.weight);
  for (const SelectiveChain& member : old) {
    masses.push_back(population.b.of_chains * std::abs(member.weight) / of_old);
  }
  for (const SeedPath* seed : found.paths) {
    masses.push_back(std::abs(seed->path.energy) * population.b.per_seed);
  }
  for (const ManifoldSeedPath& path : found.joined) {
    masses.push_back(path.energy * population.b.per_seed);
  }
  const std::uint64_t seed = hash_numbers(population.seed, RandomUse::SeedResampling, epoch);
  const double u = to_unit_double(hash_numbers(seed, RandomUse::Seeds));
  std::size_t last = masses.size();
  std::uint64_t clones = 0;
  std::vector<bool> stays(old.size(), false);
  RayCounts rays;
  for (const std::size_t index : choose_seeds(masses, chains, u)) {
    if (index == last) {
      // The one before may be a clone itself: each is told apart by the number from the first.
      const std::size_t first = population.chains.size() - 1 - clones;
      population.chains.push_back(population.chains[first].clone(++clones));
      continue;
    }
    last = index;
    clones = 0;
    if (index < old.size()) {
      stays[index] = true;
      SelectiveChain& member = population.chains.emplace_back(std::move(old[index]));
      member.weight = std::copysign(1.0, member.weight);
    } else {
      auto chain = start(found, index - old.size(), rays);
      if (chain) {
        population.chains.push_back(std::move(*chain));
      } else {
        last = masses.size();
      }
    }
  }
  for (std::size_t i = 0; i < old.size(); ++i) {
    if (!stays[i]) population.retired.add(old[i].record);
  }
}

}  // namespace ajar
