#include "integrator/selective/chain_items.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "core/random.h"
#include "core/random_use.h"
#include "integrator/metropolis/chain_film_sink.h"
#include "integrator/selective/chain_archive.h"
#include "integrator/selective/chain_walker.h"
#include "integrator/selective/heuristics.h"
#include "mcmc/primary/bootstrap_source.h"
#include "mcmc/primary/primary_runner.h"

namespace ajar {

namespace {
const PlaneMoves* moves_of(const PlaneMaps* maps, int replicate) {
  return maps != nullptr ? maps->moves(replicate) : nullptr;
}
PlaneMaps* gathering(PlaneMaps* maps) {
  return maps != nullptr && maps->gathers() ? maps : nullptr;
}
}  // namespace

void ChainItems::list(bool plain) {
  items_.clear();
  chain_counts_.assign(static_cast<std::size_t>(plan_.settings.replicates), 0);
  for (std::size_t p = 0; p < populations_.size(); ++p) {
    const ChainPopulation& population = populations_[p];
    chain_counts_[static_cast<std::size_t>(population.replicate)] += population.chains.size();
    for (std::size_t c = 0; c < population.chains.size(); ++c) items_.push_back({p, c});
    if (plain && takes_plain_samples(population)) items_.push_back({p, 0});
  }
  share_mutations();
}

bool ChainItems::takes_plain_samples(const ChainPopulation& population) const {
  return population.chains.empty() && !is_explicit(plan_.groups[population.group].kind);
}

/// N mutations on light b leave the error C·b²/N, so N/b is the same everywhere where the sum of
/// errors is smallest.
void ChainItems::share_mutations() {
  const std::size_t halves = plan_.divisions ? plan_.divisions->count() : 1;
  const auto replicates = static_cast<std::size_t>(plan_.settings.replicates);
  std::vector<double> light(halves, 0.0);
  for (const ChainPopulation& population : populations_) {
    light[static_cast<std::size_t>(population.replicate) % halves] += population.b(0.0);
  }
  const double all = std::accumulate(light.begin(), light.end(), 0.0);
  shares_.clear();
  for (std::size_t h = 0; h < halves; ++h) {
    const std::size_t own = (replicates + halves - 1 - h) / halves;
    const double share =
        light[h] / all * static_cast<double>(replicates) / static_cast<double>(own);
    shares_.push_back(all > 0.0 && own > 0 ? share : 1.0);
  }
}

/// b of a population is on average right only over all that its bootstrap can bring, finding no
/// light included. So where it found none, later samples may count neither more nor less than they
/// do where it found some: they have one weight w for all, which must not depend on what was found.
/// E[(1 − w)·bootstrap; light found] + w·E[later samples] is then b. Of I beyond the cap only the
/// bootstrap knows (see `ChainPopulation::b`), so later samples bring no more than it.
void ChainItems::refine_b(std::uint64_t samples) {
  if (populations_.empty()) return;
  double bootstrap = 0.0;
  for (const ChainPopulation& population : populations_) {
    bootstrap += static_cast<double>(population.capped.count);
  }
  const double large_steps = plan_.moves.settings.probabilities.large * plan_.moves.settings.tries *
                             effort_.mutations(samples) * static_cast<double>(plan_.pixels());
  later_weight_ = large_steps > 0.0 ? large_steps / (bootstrap + large_steps) : 0.0;
  b_.clear();
  for (const ChainPopulation& population : populations_) {
    b_.push_back(population.b(later_weight_));
  }
}

void ChainItems::run(std::uint64_t item, std::uint64_t first_sample, std::uint64_t samples,
                     PlaneMaps* maps, Film& film, Counters& counters) {
  const Item& place = items_[item];
  ChainPopulation& population = populations_[place.population];
  if (!population.chains.empty()) {
    run_chain(place, first_sample, samples, maps, film, counters);
    return;
  }
  for (std::uint64_t i = 0; i < samples; ++i) run_plain(population, maps, film, counters);
  effort_.count_chains(counters.rays, counters.mutations);
}

/// Steps are made in blocks of one mutation per pixel, each deposited by itself, so that the film's
/// bits do not depend on how many blocks a pass has.
void ChainItems::run_chain(const Item& item, std::uint64_t first_sample, std::uint64_t samples,
                           PlaneMaps* maps, Film& film, Counters& counters) {
  ChainPopulation& population = populations_[item.population];
  SelectiveChain& member = population.chains[item.chain];
  const std::size_t chains = chains_in(population.replicate);
  const auto walker = make_chain_walker(plan_, plan_.groups[population.group], population.replicate,
                                        moves_of(maps, population.replicate));
  // Steps of explicit paths do not follow the plane.
  ChainFilmSink sink(film, population.replicate, plan_.view.importance, walker->target(), counters,
                     walker->target() != nullptr ? gathering(maps) : nullptr,
                     kept_by(population.replicate));
  const double b = b_[item.population];
  const auto in_population = static_cast<double>(population.chains.size());
  walker->start(member);
  // How often chains are started is up to the clock, which must not share the effort.
  const std::uint64_t rays_to_start = walker->ray_counts().rays;
  ChainStatistics statistics;
  for (std::uint64_t block = first_sample; block < first_sample + samples; ++block) {
    const std::uint64_t steps = effort_.steps(block, chains, share_of(population.replicate));
    const double per_step = 1.0 / (static_cast<double>(steps) * in_population);
    sink.begin(stretch_.sample_weight() * member.weight * b * plan_.view.area() * per_step /
                   plan_.settings.replicates,
               member.record.by_technique.empty() ? nullptr : &member.record.by_technique);
    const ChainStatistics of_block = walker->go_on(member, steps, sink, b);
    member.record.statistics += of_block;
    statistics += of_block;
  }
  const RayCounts rays = walker->ray_counts();
  effort_.count_chains(rays.rays - rays_to_start, statistics.steps);
  count_steps(member.origin(), statistics, rays, counters);
}

/// A population whose bootstrap found no light has no chain to run. Its paths, if they are of
/// numbers, are sampled independently instead. They stand for the large steps that its chains would
/// have made, and have their weight: see `refine_b`. What one of them carries is spread over a
/// short chain that starts from it (Cline et al. 2005), since light so hard to find would be a
/// firefly: the chain leaves the distribution of its start as it is, so each of its states stands
/// for the sample as well.
void ChainItems::run_plain(ChainPopulation& population, PlaneMaps* maps, Film& film,
                           Counters& counters) {
  if (later_weight_ == 0.0) return;
  constexpr std::uint64_t kSteps = SelectiveHeuristics::kStepsWithoutSeed;
  std::size_t seedless = 0;
  for (const ChainPopulation& other : populations_) {
    if (other.replicate == population.replicate && takes_plain_samples(other)) ++seedless;
  }
  const double mutations = plan_.mutations * static_cast<double>(plan_.pixels()) /
                           plan_.settings.replicates / static_cast<double>(seedless);
  const double share =
      chains_in(population.replicate) > 0 ? SelectiveHeuristics::kShareWithoutSeeds : 1.0;
  const auto count = static_cast<std::uint64_t>(std::max(1.0, share * mutations));
  const PathGroup& group = plan_.groups[population.group];
  const auto target = plan_.make_target(group, population.replicate);
  PrimaryRunner runner(plan_.chain_settings_of(population.replicate), *plan_.moves.mutation,
                       group.shape, *target, moves_of(maps, population.replicate));
  ChainFilmSink sink(film, population.replicate, plan_.view.importance, target.get(), counters,
                     gathering(maps), kept_by(population.replicate));
  const double scale =
      later_weight_ * plan_.view.area() / static_cast<double>(count) / plan_.settings.replicates;
  SplatBuffer splats;
  const std::uint64_t seed = hash_numbers(population.seed, RandomUse::PlainSamples);
  counters.mutations += count;
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t index = population.plain_samples++;
    BootstrapSource source(seed, index);
    splats.clear();
    const double scalar = target->evaluate(source, Change{}, splats);
    target->rejected();
    const double capped = std::min(scalar, plan_.moves.settings.large_step_cap);
    population.plain_statistics.large_steps.add(std::isfinite(scalar) ? std::max(0.0, capped)
                                                                      : 0.0);
    if (std::isnan(scalar)) {
      ++counters.discarded_nan;
    } else if (std::isinf(scalar)) {
      ++counters.discarded_infinite;
    } else if (scalar < 0.0) {
      ++counters.discarded_negative;
    } else if (scalar > 0.0) {
      PrimaryChain chain(group.shape, hash_numbers(seed, RandomUse::Chain, index),
                         bootstrap_key(seed, index), scalar);
      sink.begin(scale * capped / static_cast<double>(kSteps), nullptr);
      runner.run(chain, kSteps, sink);
      counters.mutations += kSteps;
    }
  }
  counters.add_rays(target->ray_counts());
}

void ChainItems::save_state(OutputArchive& archive) const { archive(b_, later_weight_); }

void ChainItems::load_state(InputArchive& archive) {
  archive(b_, later_weight_);
  if (b_.size() != populations_.size()) {
    throw std::runtime_error("other chains are prepared than there were");
  }
}

void ChainItems::check_b() const {
  bool fits = later_weight_ >= 0.0 && later_weight_ <= 1.0;
  for (std::size_t i = 0; i < b_.size(); ++i) {
    fits = fits && std::isfinite(b_[i]) && b_[i] >= 0.0 &&
           (b_[i] > 0.0 || populations_[i].chains.empty());
  }
  if (!fits) throw std::runtime_error("the brightness of chains cannot be");
}

template <typename A>
void ChainItems::serialize_chains(A& archive, const WorkShare& share, std::uint64_t first) {
  for (std::size_t i = 0; i < items_.size(); ++i) {
    if (!share.has(first + i)) continue;
    ChainPopulation& population = populations_[items_[i].population];
    if (population.chains.empty()) {
      serialize_plain(archive, population);
    } else {
      serialize_chain(archive, plan_.scene, population.chains[items_[i].chain]);
    }
  }
}

void ChainItems::give_news(OutputArchive& archive, const WorkShare& share, std::uint64_t first) {
  serialize_chains(archive, share, first);
}

void ChainItems::take_news(InputArchive& archive, const WorkShare& share, std::uint64_t first) {
  serialize_chains(archive, share, first);
}

}  // namespace ajar
