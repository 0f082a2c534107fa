#pragma once
#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/archive.h"
#include "core/milestones.h"
#include "core/parallel_for.h"
#include "core/random_use.h"
#include "integrator/metropolis/chain_film_sink.h"
#include "integrator/metropolis/chain_method.h"
#include "integrator/metropolis/chain_report.h"
#include "integrator/metropolis/population.h"
#include "integrator/metropolis/visit_maps.h"

namespace ajar {

/// The parameter `chains`.
ParameterSpec chains_parameter();

/// A sample per pixel is a mutation per pixel.
///
///     bootstrap   per replicate and depth k, independent paths give b_k, the mean of I, and seeds
///                 in proportion to I;
///     render      from each seed a chain. A step proposes a state y from x and goes there with
///                 probability a = min(1, I(y)/I(x)). The film gets a·f(y)/I(y) and
///                 (1 − a)·f(x)/I(x), times b_k over the number of the steps of that depth.
///
/// The picture is unbiased for any number of steps, since seeds and b come from the same samples
/// (Veach 1997, section 11.3.1).
///
/// `Space`, in which chains walk:
///
///     Member          a chain and what it has done
///     seed            makes the chains that start from a bootstrap
///     Walker          makes steps of chains of one group, on one thread
///     moves           as its kernels number them
///     save, load      members in checkpoints, and what they cannot be: check, check_state
template <typename Space>
class ChainIntegrator final : public ChainMethod {
 public:
  /// `chains`: over all replicates.
  ChainIntegrator(const Scene& scene, const RenderSettings& settings, ChainOrder order,
                  std::size_t chains, Space space)
      : ChainMethod(scene, settings, std::move(order)), chains_(chains), space_(std::move(space)) {}

  PreparationRound begin_preparation(int round) override;
  void prepare_item(int round, std::uint64_t item, Counters& counters) override;
  void skip_preparation(PreparationCut of) override;

  std::uint64_t items_in_round() const override;
  void begin_pass(std::uint64_t first_sample, std::uint64_t samples, Film& film) override;
  void run_item(std::uint64_t item, std::uint64_t first_sample, std::uint64_t samples, Film& film,
                Counters& counters) override;
  MethodReport report() const override;

  void save_state(OutputArchive& archive) const override;
  void load_state(InputArchive& archive, std::uint64_t samples) override;
  void export_delta(OutputArchive& archive, const WorkSlice& slice) override;
  void import_delta(InputArchive& archive, const WorkSlice& slice) override;
  std::uint64_t memory_bytes() const override;

 private:
  using Member = typename Space::Member;
  struct MeasuredPopulation : PopulationOf<Member> {
    Moments b;  ///< I over the bootstrap: its mean is ∫ I
  };
  struct Item {
    std::size_t population;
    std::size_t chain;
  };

  void seed();
  /// Mutations of a chain of a replicate that has `chains` of them, from sample `sample` to the
  /// next.
  std::uint64_t steps(std::uint64_t sample, std::size_t chains) const;
  double brightness() const override;
  bool has_chains() const override { return !items_.empty(); }
  std::uint64_t bootstrap_samples() const;
  ChainProblem problem(std::size_t group) const {
    return {scene(), groups()[group], view(), order().part};
  }

  std::size_t chains_;
  Space space_;
  std::vector<MeasuredPopulation> populations_;
  std::vector<SampleBlock> blocks_;      ///< samples of the bootstrap
  std::vector<Item> items_;              ///< one per chain
  std::vector<std::size_t> chains_per_;  ///< replicate
  std::uint64_t doubled_at_ = 0;         ///< samples per pixel
};

// ---------------------------------------------------------------- bootstrap

template <typename Space>
PreparationRound ChainIntegrator<Space>::begin_preparation(int round) {
  if (round == 0) {
    populations_ =
        make_populations<MeasuredPopulation>(groups(), settings().replicates, settings().seed);
    blocks_ = share_bootstrap(populations_, groups(), settings().replicates, order().bootstrap);
    return {.items = blocks_.size(), .effort = bootstrap_effort()};
  }
  seed();
  return {};
}

template <typename Space>
void ChainIntegrator<Space>::prepare_item(int /*round*/, std::uint64_t item, Counters& counters) {
  MeasuredPopulation& population = populations_[blocks_[item].owner];
  sample_bootstrap(population, blocks_[item], *make_seed_target(problem(population.group)),
                   counters);
}

template <typename Space>
void ChainIntegrator<Space>::seed() {
  for (MeasuredPopulation& population : populations_) {
    population.b = bootstrap_moments(population.weights);
  }
  const auto replicates = static_cast<std::size_t>(settings().replicates);
  share_chains(
      populations_, groups(), std::max<std::size_t>(1, chains_ / replicates),
      [](const MeasuredPopulation& population) { return population.b.mean(); },
      [this](MeasuredPopulation& population, std::size_t chains) {
        population.chains =
            space_.seed(problem(population.group), population.seed, population.weights, chains);
      });
  chains_per_.assign(replicates, 0);
  for (std::size_t p = 0; p < populations_.size(); ++p) {
    const std::size_t chains = populations_[p].chains.size();
    for (std::size_t c = 0; c < chains; ++c) items_.push_back({p, c});
    chains_per_[static_cast<std::size_t>(populations_[p].replicate)] += chains;
  }
  if (items_.empty() && !groups().empty()) add_concern(no_seeds(bootstrap_samples()));
  const double b = brightness();
  space_.begin(view(), settings().replicates, b > 0.0 && std::isfinite(b) ? b : 1.0);
}

template <typename Space>
void ChainIntegrator<Space>::skip_preparation(PreparationCut of) {
  populations_.clear();
  ChainMethod::skip_preparation(of);
}

// ---------------------------------------------------------------- chains

template <typename Space>
std::uint64_t ChainIntegrator<Space>::items_in_round() const {
  return unprepared() != nullptr ? unprepared()->items_in_round() : items_.size();
}

template <typename Space>
std::uint64_t ChainIntegrator<Space>::steps(std::uint64_t sample, std::size_t chains) const {
  const double per_sample = view().pixels / settings().replicates / static_cast<double>(chains);
  const auto upto = [&](std::uint64_t samples) {
    return static_cast<std::uint64_t>(std::ceil(static_cast<double>(samples) * per_sample));
  };
  return std::max<std::uint64_t>(1, upto(sample + 1) - upto(sample));
}

/// Maps of visits change at counts fixed in advance, which passes do not cross (`PassSchedule`):
/// where passes end otherwise is up to the clock.
template <typename Space>
void ChainIntegrator<Space>::begin_pass(std::uint64_t first_sample, std::uint64_t /*samples*/,
                                        Film& /*film*/) {
  const std::uint64_t milestone =
      last_doubling(first_sample, static_cast<std::uint64_t>(settings().replicates));
  if (space_.maps() == nullptr || milestone <= doubled_at_) return;
  doubled_at_ = milestone;
  space_.maps()->end_epoch(static_cast<double>(milestone));
}

/// Each mutation per pixel is deposited by itself, so that the film's bits do not depend on how
/// many a pass has.
template <typename Space>
void ChainIntegrator<Space>::run_item(std::uint64_t item, std::uint64_t first_sample,
                                      std::uint64_t samples, Film& film, Counters& counters) {
  if (unprepared() != nullptr) {
    unprepared()->run_item(item, first_sample, samples, film, counters);
    return;
  }
  MeasuredPopulation& population = populations_[items_[item].population];
  Member& member = population.chains[items_[item].chain];
  typename Space::Walker walker(space_, problem(population.group), population.replicate);
  VisitMaps* const maps = space_.maps();
  ChainFilmSink sink(film, population.replicate, view().importance, walker.target(), counters,
                     maps != nullptr && maps->gathers() ? maps : nullptr, order().part);
  const double b = population.b.mean();
  const auto chains = static_cast<double>(population.chains.size());
  ChainStatistics statistics;
  walker.start(member);
  for (std::uint64_t sample = first_sample; sample < first_sample + samples; ++sample) {
    const std::uint64_t n =
        steps(sample, chains_per_[static_cast<std::size_t>(population.replicate)]);
    sink.begin(member.weight * b * view().area() / (static_cast<double>(n) * chains) /
                   settings().replicates,
               member.record.by_technique.empty() ? nullptr : &member.record.by_technique);
    const ChainStatistics of_sample = walker.go_on(member, n, sink, b);
    member.record.statistics += of_sample;
    statistics += of_sample;
  }
  count_steps(member.chain.origin, statistics, walker.ray_counts(), counters);
}

// ---------------------------------------------------------------- film

template <typename Space>
double ChainIntegrator<Space>::brightness() const {
  double b = 0.0;
  for (const MeasuredPopulation& population : populations_) b += population.b.mean();
  return b / settings().replicates;
}

// ---------------------------------------------------------------- report, state

template <typename Space>
std::uint64_t ChainIntegrator<Space>::bootstrap_samples() const {
  std::uint64_t samples = 0;
  for (const MeasuredPopulation& population : populations_) samples += population.b.count;
  return samples;
}

template <typename Space>
MethodReport ChainIntegrator<Space>::report() const {
  if (unprepared() != nullptr) return unprepared()->report();
  ChainReporter reporter(bootstrap_samples());
  for (std::size_t g = 0; g < groups().size(); ++g) {
    ChainReporter::OfGroup group(groups()[g], space_.moves());
    for (const MeasuredPopulation& population : populations_) {
      if (population.group != g) continue;
      group.add_b(population.b.mean(), population.b.standard_error(), settings().replicates);
      for (const Member& member : population.chains) group.add_chain(member.record);
    }
    reporter.add(std::move(group));
  }
  return reporter.report();
}

template <typename Space>
void ChainIntegrator<Space>::save_state(OutputArchive& archive) const {
  archive(static_cast<std::uint64_t>(items_.size()));
  for (const Item& item : items_) {
    space_.save(archive, scene(), populations_[item.population].chains[item.chain]);
  }
  if (space_.maps() != nullptr) {
    archive(doubled_at_);
    space_.maps()->save_state(archive);
  }
}

template <typename Space>
void ChainIntegrator<Space>::load_state(InputArchive& archive, std::uint64_t samples) {
  std::uint64_t chains = 0;
  archive(chains);
  if (chains != items_.size()) {
    throw std::runtime_error("other chains are prepared than there were");
  }
  const auto replicates = static_cast<std::uint64_t>(settings().replicates);
  // A pass that was cut short may have come as far as this; each sample has a step at least.
  const double most_steps =
      static_cast<double>(milestone_after(samples, replicates)) * (1.0 + view().pixels);
  for (const Item& item : items_) {
    Member& member = populations_[item.population].chains[item.chain];
    space_.load(archive, scene(), member);
    space_.check(member, groups()[populations_[item.population].group], most_steps);
  }
  parallel_for(items_.size(), [&](std::size_t i) {
    const MeasuredPopulation& population = populations_[items_[i].population];
    space_.check_state(problem(population.group), population.chains[items_[i].chain]);
  });
  if (space_.maps() != nullptr) {
    archive(doubled_at_);
    if (doubled_at_ > samples) throw std::runtime_error("corrupt checkpoint: wrong pass");
    space_.maps()->load_state(archive);
  }
}

template <typename Space>
void ChainIntegrator<Space>::export_delta(OutputArchive& archive, const WorkSlice& slice) {
  for (std::size_t i = 0; i < items_.size(); ++i) {
    if (!slice.has(i)) continue;
    space_.save(archive, scene(), populations_[items_[i].population].chains[items_[i].chain]);
  }
  if (space_.maps() != nullptr) space_.maps()->export_delta(archive);
}

template <typename Space>
void ChainIntegrator<Space>::import_delta(InputArchive& archive, const WorkSlice& slice) {
  for (std::size_t i = 0; i < items_.size(); ++i) {
    if (!slice.has(i)) continue;
    space_.load(archive, scene(), populations_[items_[i].population].chains[items_[i].chain]);
  }
  if (space_.maps() != nullptr) space_.maps()->import_delta(archive);
}

template <typename Space>
std::uint64_t ChainIntegrator<Space>::memory_bytes() const {
  std::uint64_t bytes = space_.maps() != nullptr ? space_.maps()->memory_bytes() : 0;
  for (const MeasuredPopulation& population : populations_) {
    for (const Member& member : population.chains) bytes += member.memory_bytes();
  }
  return bytes;
}

}  // namespace ajar
