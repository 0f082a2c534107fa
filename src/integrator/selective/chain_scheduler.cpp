#include "integrator/selective/chain_scheduler.h"

#include <numeric>

#include "integrator/metropolis/chain_film_sink.h"
#include "integrator/selective/chain_archive.h"
#include "integrator/selective/chain_walker.h"

namespace ajar {

void ChainScheduler::list() {
  items_.clear();
  chain_counts_.assign(static_cast<std::size_t>(prepared_.config.settings.replicates), 0);
  for (std::size_t p = 0; p < populations_.size(); ++p) {
    const ChainPopulation& population = populations_[p];
    chain_counts_[static_cast<std::size_t>(population.replicate)] += population.chains.size();
    for (std::size_t c = 0; c < population.chains.size(); ++c) items_.push_back({p, c});
  }
  share_mutations();
}

/// N mutations on light b leave the error C·b²/N, so N/b is the same everywhere where the sum of
/// errors is smallest.
void ChainScheduler::share_mutations() {
  const std::size_t halves = prepared_.divisions ? prepared_.divisions->count() : 1;
  const auto replicates = static_cast<std::size_t>(prepared_.config.settings.replicates);
  std::vector<double> light(halves, 0.0);
  for (const ChainPopulation& population : populations_) {
    light[static_cast<std::size_t>(population.replicate) % halves] += population.b.total;
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

/// Steps are made in blocks of one mutation per pixel, each deposited by itself, so that the film's
/// bits do not depend on how many blocks a pass has.
void ChainScheduler::run(std::uint64_t item, std::uint64_t first_sample, std::uint64_t samples,
                         Film& film, Counters& counters) {
  ChainPopulation& population = populations_[items_[item].population];
  SelectiveChain& member = population.chains[items_[item].chain];
  const std::size_t chains = chain_counts_[static_cast<std::size_t>(population.replicate)];
  const auto walker =
      make_chain_walker(prepared_, prepared_.groups()[population.group], population.replicate);
  ChainFilmSink sink(film, population.replicate, prepared_.view.importance, walker->target(),
                     counters);
  const auto in_population = static_cast<double>(population.chains.size());
  walker->start(member);
  // The number of starts is up to the clock, which must not share the effort.
  const std::uint64_t rays_to_start = walker->ray_counts().rays;
  ChainStatistics statistics;
  for (std::uint64_t block = first_sample; block < first_sample + samples; ++block) {
    const std::uint64_t steps = allocation_.steps(block, chains, share_of(population.replicate));
    const double per_step = 1.0 / (static_cast<double>(steps) * in_population);
    sink.begin(epoch_.sample_weight() * member.weight * population.b.total * prepared_.view.area() *
                   per_step / prepared_.config.settings.replicates,
               member.record.by_technique.empty() ? nullptr : &member.record.by_technique);
    const ChainStatistics of_block = walker->go_on(member, steps, sink);
    member.record.statistics += of_block;
    statistics += of_block;
  }
  const RayCounts rays = walker->ray_counts();
  allocation_.count_chains(rays.rays - rays_to_start, statistics.steps);
  count_steps(member.origin(), statistics, rays, counters);
}

template <typename A>
void ChainScheduler::serialize_chains(A& archive, const WorkSlice& slice, std::uint64_t first) {
  for (std::size_t i = 0; i < items_.size(); ++i) {
    if (!slice.has(first + i)) continue;
    serialize_chain(archive, prepared_.scene(),
                    populations_[items_[i].population].chains[items_[i].chain]);
  }
}

void ChainScheduler::export_delta(OutputArchive& archive, const WorkSlice& slice,
                                  std::uint64_t first) {
  serialize_chains(archive, slice, first);
}

void ChainScheduler::import_delta(InputArchive& archive, const WorkSlice& slice,
                                  std::uint64_t first) {
  serialize_chains(archive, slice, first);
}

}  // namespace ajar
