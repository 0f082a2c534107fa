#include "integrator/selective/chain_recruits.h"

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
auto order_of(const StrongPath& path) {
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

class ChainRecruits::Sink final : public StrongPathSink {
 public:
  Sink(const ChainRecruits& recruits, Counters& counters)
      : recruits_(recruits), counters_(counters) {}

  double grain() const override { return recruits_.grain_; }
  bool spread(SampleSource& numbers, StrongPath& path) override {
    Recruit recruit{path, PathNumbers(numbers, path), {}};
    const auto chain =
        start_chain_of(recruits_.plan_, recruit.numbers, path, std::nullopt, counters_);
    recruit.scalar = chain ? chain->chain().scalar : 0.0;
    // Rounding may have moved the path off an edge.
    if (!(*recruit.scalar > 0.0 && std::isfinite(*recruit.scalar))) return false;
    recruits_.share_with_manifolds(recruit, *chain, counters_);
    if (recruit.path.energy != 0.0) recruits_.keep(std::move(recruit));
    return true;
  }

 private:
  const ChainRecruits& recruits_;
  Counters& counters_;
};

double ChainRecruits::evaluate(const Recruit& recruit, RayCounts& rays) const {
  const auto chain = start_chain_of(plan_, recruit.numbers, recruit.path, std::nullopt, rays);
  return chain ? chain->chain().scalar : 0.0;
}

void ChainRecruits::share_with_manifolds(Recruit& recruit, const SelectiveChain& chain,
                                         RayCounts& rays) const {
  const PathGroup& group = plan_.group_of(recruit.path);
  if (!recruit.path.hit_only || !PathSeeds::has_manifolds(group)) return;
  ManifoldSeeds manifolds(plan_.scene, *group.photons, bounds_of(group, plan_.view),
                          SelectiveHeuristics::kManifoldTries);
  recruit.path.energy *=
      manifolds.hit_share(std::get<PathChain>(chain.state).path,
                          hash_numbers(recruit.path.key(), RandomUse::ManifoldSeed));
  rays.add_rays(manifolds.ray_counts());
}

std::unique_ptr<StrongPathSink> ChainRecruits::make(Film& /*film*/, Counters& counters) const {
  return std::make_unique<Sink>(*this, counters);
}

void ChainRecruits::keep(Recruit recruit) const {
  const std::lock_guard lock(mutex_);
  recruits_.push_back(std::move(recruit));
}

void ChainRecruits::load_recruits(InputArchive& archive, std::vector<Recruit>& recruits) const {
  std::uint64_t count = 0;
  archive(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    Recruit& recruit = recruits.emplace_back();
    archive(recruit);
    const int replicate = recruit.path.replicate;
    if (!recruit.numbers.fit(recruit.path) || replicate < 0 ||
        replicate >= plan_.settings.replicates) {
      throw std::runtime_error("a path that was found does not fit the render");
    }
  }
}

void ChainRecruits::check_recruit(const Recruit& recruit) const {
  const StrongPath& path = recruit.path;
  const TechniqueChoice& choice = plan_.group_of(path.technique.depth()).choice;
  bool known = false;
  for (std::size_t i = 0; i < choice.size(); ++i) known = known || choice[i] == path.technique;
  if (!known || !plan_.view.contains(path.raster) || !std::isfinite(path.energy)) {
    throw std::runtime_error("a path that was found cannot be");
  }
  // A chain that starts there must have what `ChainRunner` sees there.
  RayCounts rays;
  const double scalar = evaluate(recruit, rays);
  if (!(scalar > 0.0 && std::isnormal(scalar)) || (recruit.scalar && *recruit.scalar != scalar)) {
    throw std::runtime_error("a path that was found leads elsewhere");
  }
}

void ChainRecruits::save_state(OutputArchive& archive) const {
  archive(grain_, static_cast<std::uint64_t>(recruits_.size() + shared_.size()));
  for (const Recruit& recruit : shared_) archive(recruit);
  for (const Recruit& recruit : recruits_) archive(recruit);
}

void ChainRecruits::load_state(InputArchive& archive) {
  manifolds_.clear();
  recruits_.clear();
  shared_.clear();
  archive(grain_);
  if (!(grain_ >= 0.0 && std::isfinite(grain_))) {
    throw std::runtime_error("paths that are found cannot be as coarse");
  }
  load_recruits(archive, shared_);
  parallel_for(shared_.size(), [&](std::size_t i) { check_recruit(shared_[i]); });
  // All of them share b.
  if (!std::isfinite(energy())) throw std::runtime_error("paths that were found are too bright");
}

void ChainRecruits::give_news(OutputArchive& archive) {
  archive(static_cast<std::uint64_t>(recruits_.size()));
  for (const Recruit& recruit : recruits_) archive(recruit);
  recruits_.clear();
}

void ChainRecruits::take_news(InputArchive& archive) { load_recruits(archive, shared_); }

void ChainRecruits::set_grain(double per_sample, double camera_samples) {
  const double whole =
      per_sample * camera_samples * static_cast<double>(plan_.pixels()) / plan_.settings.replicates;
  grain_ = whole / static_cast<double>(plan_.chains_per_replicate());
}

void ChainRecruits::expect_unknown(double camera_samples) {
  set_grain(plan_.brightness, camera_samples);
}

void ChainRecruits::expect(const std::vector<ChainPopulation>& populations, double camera_samples) {
  double b = 0.0;
  for (const ChainPopulation& population : populations) b += population.b(0.0);
  set_grain(std::max(b / plan_.settings.replicates * plan_.view.area_per_pixel(),
                     SelectiveHeuristics::kLeastShareOfChains * plan_.brightness),
            camera_samples);
}

double ChainRecruits::energy() const {
  // In an order that does not depend on threads.
  std::vector<double> energies;
  const auto add = [&](const Recruit& recruit) {
    energies.push_back(std::abs(recruit.path.energy));
  };
  std::for_each(recruits_.begin(), recruits_.end(), add);
  std::for_each(shared_.begin(), shared_.end(), add);
  std::sort(energies.begin(), energies.end());
  return std::accumulate(energies.begin(), energies.end(), 0.0);
}

void ChainRecruits::divide_anew(const Divisions& before) {
  for (Recruit& recruit : recruits_) {
    StrongPath& path = recruit.path;
    const auto share_of = [&](const Divisions& divisions) {
      return divisions.of(path.replicate).chain_share(path.strength, path.raster);
    };
    const float change = share_of(*plan_.divisions) / share_of(before);
    path.value *= change;
    path.energy *= static_cast<double>(change);
    if (change != 1.F) recruit.scalar.reset();
  }
  std::erase_if(recruits_, [](const Recruit& recruit) { return recruit.path.energy == 0.0; });
}

std::vector<ChainRecruits::Found> ChainRecruits::sorted_recruits(
    const std::vector<ChainPopulation>& populations) {
  std::move(shared_.begin(), shared_.end(), std::back_inserter(recruits_));
  shared_.clear();
  std::sort(recruits_.begin(), recruits_.end(),
            [](const Recruit& a, const Recruit& b) { return order_of(a.path) < order_of(b.path); });
  std::map<std::pair<int, const PathGroup*>, std::size_t> by_replicate_and_group;
  for (std::size_t p = 0; p < populations.size(); ++p) {
    by_replicate_and_group[{populations[p].replicate, &plan_.groups[populations[p].group]}] = p;
  }
  std::vector<Found> found(populations.size());
  for (const Recruit& recruit : recruits_) {
    const StrongPath& path = recruit.path;
    found[by_replicate_and_group.at({path.replicate, &plan_.group_of(path)})].recruits.push_back(
        &recruit);
  }
  return found;
}

std::vector<RecruitStretch> ChainRecruits::stretches(std::uint64_t first,
                                                     std::uint64_t last) const {
  const auto replicates = static_cast<std::uint64_t>(plan_.settings.replicates);
  std::vector<RecruitStretch> all;
  for (std::uint64_t replicate = 0; replicate < replicates; ++replicate) {
    const std::uint64_t samples = samples_of(replicate, replicates, first, last) * plan_.pixels();
    all.push_back({static_cast<double>(samples), last});
  }
  return all;
}

void ChainRecruits::look_on(const std::vector<ChainPopulation>& populations, std::uint64_t first,
                            std::uint64_t now, std::uint64_t last) {
  if (now <= first) return;
  manifolds_.go_on(populations, stretches(first, last),
                   static_cast<double>(now - first) / static_cast<double>(last - first));
}

void ChainRecruits::join(std::vector<ChainPopulation>& populations, std::uint64_t first,
                         std::uint64_t last) {
  join_all(populations, stretches(first, last));
}

void ChainRecruits::join_scattered(std::vector<ChainPopulation>& populations,
                                   double camera_samples) {
  const int replicates = plan_.settings.replicates;
  for (Recruit& recruit : recruits_) {
    recruit.path.replicate =
        static_cast<int>(hash_numbers(recruit.path.key(), RandomUse::RecruitReplicate) %
                         static_cast<std::uint64_t>(replicates));
  }
  join_all(populations, std::vector<RecruitStretch>(static_cast<std::size_t>(replicates),
                                                    {camera_samples / replicates, 0}));
}

void ChainRecruits::join_all(std::vector<ChainPopulation>& populations,
                             const std::vector<RecruitStretch>& stretches) {
  auto found = sorted_recruits(populations);
  manifolds_.go_on(populations, stretches, 1.0);
  for (std::size_t p = 0; p < populations.size(); ++p) found[p].joined = manifolds_.take(p);
  manifolds_.clear();
  for (std::size_t replicate = 0; replicate < stretches.size(); ++replicate) {
    join_replicate(populations, found, static_cast<int>(replicate), stretches[replicate]);
  }
  recruits_.clear();
}

void ChainRecruits::join_replicate(std::vector<ChainPopulation>& populations,
                                   const std::vector<Found>& found, int replicate,
                                   const RecruitStretch& stretch) const {
  if (stretch.samples == 0.0) return;
  std::vector<std::size_t> own;
  std::vector<double> b;
  for (std::size_t p = 0; p < populations.size(); ++p) {
    if (populations[p].replicate != replicate) continue;
    own.push_back(p);
    if (plan_.kind == ChainKind::SpreadPath) end_chains(populations[p]);
    merge(populations[p], found[p], stretch.samples);
    b.push_back(populations[p].joined->b);
  }
  const std::vector<std::size_t> shares = apportion(b, plan_.chains_per_replicate());
  for (std::size_t i = 0; i < own.size(); ++i) {
    resample(populations[own[i]], found[own[i]], shares[i], stretch.number);
  }
}

/// What chains of `erpt` start from is spread by them alone.
void ChainRecruits::end_chains(ChainPopulation& population) {
  for (const SelectiveChain& chain : population.chains) population.retired.add(chain.record);
  population.chains.clear();
  population.joined.reset();
  population.samples_behind = 0.0;
}

void ChainRecruits::merge(ChainPopulation& population, const Found& found, double samples) const {
  const double before = population.samples_behind;
  const double share = samples / (before + samples);
  const double scale = share / samples / plan_.view.area_per_pixel();
  ChainPopulation::Joined joined{0.0, 0.0, scale, 0.0};
  const auto add = [&](double energy) {
    const double mass = std::abs(energy) * scale;
    joined.b += mass;
    joined.variance += mass * mass;
  };
  for (const Recruit* recruit : found.recruits) add(recruit->path.energy);
  for (const ManifoldRecruit& path : found.joined) add(path.energy);
  if (population.joined) {
    joined.of_chains = (1.0 - share) * population.joined->b;
    joined.b += joined.of_chains;
    joined.variance += (1.0 - share) * (1.0 - share) * population.joined->variance;
  }
  population.joined = joined;
  population.samples_behind = before + samples;
}

std::optional<SelectiveChain> ChainRecruits::start(const Found& found, std::size_t number,
                                                   RayCounts& rays) const {
  if (number < found.recruits.size()) {
    const Recruit& recruit = *found.recruits[number];
    return start_chain_of(plan_, recruit.numbers, recruit.path, recruit.scalar, rays);
  }
  const ManifoldRecruit& joined = found.joined[number - found.recruits.size()];
  return start_chain_at(joined.path, joined.key);
}

void ChainRecruits::resample(ChainPopulation& population, const Found& found, std::size_t chains,
                             std::uint64_t stretch) const {
  const ChainPopulation::Joined& joined = *population.joined;
  std::vector<SelectiveChain> old = std::move(population.chains);
  population.chains.clear();
  std::vector<double> masses;
  masses.reserve(old.size() + found.recruits.size() + found.joined.size());
  double of_old = 0.0;
  for (const SelectiveChain& member : old) of_old += std::abs(member.weight);
  for (const SelectiveChain& member : old) {
    masses.push_back(joined.of_chains * std::abs(member.weight) / of_old);
  }
  for (const Recruit* recruit : found.recruits) {
    masses.push_back(std::abs(recruit->path.energy) * joined.of_recruits);
  }
  for (const ManifoldRecruit& path : found.joined) {
    masses.push_back(path.energy * joined.of_recruits);
  }
  const std::uint64_t seed = hash_numbers(population.seed, RandomUse::RecruitSeeds, stretch);
  const double u = to_unit_double(hash_numbers(seed, RandomUse::Seeds));
  std::size_t last = masses.size();
  std::uint64_t twins = 0;
  std::vector<bool> stays(old.size(), false);
  RayCounts rays;
  for (const std::size_t index : choose_seeds(masses, chains, u)) {
    if (index == last) {
      // The one before may be a twin itself: each is told apart by the number from the first.
      const std::size_t first = population.chains.size() - 1 - twins;
      population.chains.push_back(population.chains[first].twin(++twins));
      continue;
    }
    last = index;
    twins = 0;
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
