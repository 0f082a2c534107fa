#pragma once
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/archive.h"
#include "core/milestones.h"
#include "core/parallel_for.h"
#include "core/random_use.h"
#include "integrator/make_filter.h"
#include "integrator/metropolis/chain_film_sink.h"
#include "integrator/metropolis/chain_report.h"
#include "integrator/metropolis/heuristics.h"
#include "integrator/metropolis/population.h"
#include "integrator/montecarlo/blind_spots.h"
#include "integrator/montecarlo/path_family.h"
#include "integrator/montecarlo/path_parameters.h"

namespace ajar {

/// What published methods whose chains make all light agree on.
struct ChainOrder {
  PathSamplerSettings sampler;  ///< of the bootstrap
  std::vector<PathGroup> groups;
  std::uint64_t bootstrap;  ///< samples, over all groups and replicates
  std::size_t chains;       ///< over all replicates
  Parameters monte_carlo;   ///< of what renders if there was no time for a bootstrap
};

/// The parameters `bootstrap` and `chains`.
void add_chain_counts(std::vector<ParameterSpec>& specs);
/// All but the groups and the start of Russian roulette, by these parameters and those of the
/// family of path sampling.
ChainOrder chain_order(const RenderSettings& settings, const Parameters& parameters,
                       const std::map<std::string, std::string>& path_parameters);

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
class ChainIntegrator final : public Integrator {
 public:
  ChainIntegrator(const Scene& scene, const RenderSettings& settings, ChainOrder order, Space space)
      : scene_(scene),
        settings_(settings),
        space_(std::move(space)),
        view_(view_of(scene, settings)),
        order_(std::move(order)),
        concerns_(blind_spots(scene, settings, order_.sampler)) {}

  PreparationRound begin_preparation(int round) override;
  void prepare_item(int round, std::uint64_t item, Counters& counters) override;
  void skip_preparation() override;
  Findings findings() const override;

  std::vector<LayerSpec> layers() const override;
  std::uint64_t items_in_round() const override;
  void run_item(std::uint64_t item, std::uint64_t first_sample, std::uint64_t samples, Film& film,
                Counters& counters) override;
  bool is_of_chains(std::uint64_t /*item*/) const override { return !unprepared_; }
  DevelopScale develop_scale(const LayerSpec& layer, std::uint64_t samples,
                             std::optional<int> replicate) const override;
  MethodReport report() const override;

  bool keeps_state() const override { return !unprepared_; }
  void save_state(OutputArchive& archive) const override;
  void load_state(InputArchive& archive, std::uint64_t samples) override;
  void give_news(OutputArchive& archive, const WorkShare& share) override;
  void take_news(InputArchive& archive, const WorkShare& share) override;
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
  /// b over all depths, the mean of the replicates.
  double brightness() const;
  std::uint64_t bootstrap_samples() const;

  const Scene& scene_;
  RenderSettings settings_;
  Space space_;
  ChainView view_;
  ChainOrder order_;
  std::vector<Warning> concerns_;
  bool misses_light_ = !concerns_.empty();

  std::vector<MeasuredPopulation> populations_;
  std::vector<SampleBlock> blocks_;         ///< of the bootstrap
  std::vector<Item> items_;                 ///< one per chain
  std::vector<std::size_t> chains_per_;     ///< replicate
  std::unique_ptr<Integrator> unprepared_;  ///< renders if there was no time for a bootstrap
};

// ---------------------------------------------------------------- bootstrap

template <typename Space>
PreparationRound ChainIntegrator<Space>::begin_preparation(int round) {
  if (round == 0) {
    populations_ =
        make_populations<MeasuredPopulation>(order_.groups, settings_.replicates, settings_.seed);
    blocks_ = share_bootstrap(populations_, order_.groups, settings_.replicates, order_.bootstrap);
    return {.items = blocks_.size()};
  }
  seed();
  return {};
}

template <typename Space>
void ChainIntegrator<Space>::prepare_item(int /*round*/, std::uint64_t item, Counters& counters) {
  MeasuredPopulation& population = populations_[blocks_[item].owner];
  sample_bootstrap(population, blocks_[item],
                   *make_path_target(scene_, order_.groups[population.group], view_), counters);
}

template <typename Space>
void ChainIntegrator<Space>::seed() {
  for (MeasuredPopulation& population : populations_) {
    population.b = bootstrap_moments(population.weights);
  }
  const auto replicates = static_cast<std::size_t>(settings_.replicates);
  share_chains(
      populations_, order_.groups, std::max<std::size_t>(1, order_.chains / replicates),
      [](const MeasuredPopulation& population) { return population.b.mean(); },
      [this](MeasuredPopulation& population, std::size_t chains) {
        population.chains = space_.seed(scene_, order_.groups[population.group], view_,
                                        population.seed, population.weights, chains);
      });
  chains_per_.assign(replicates, 0);
  for (std::size_t p = 0; p < populations_.size(); ++p) {
    const std::size_t chains = populations_[p].chains.size();
    for (std::size_t c = 0; c < chains; ++c) items_.push_back({p, c});
    chains_per_[static_cast<std::size_t>(populations_[p].replicate)] += chains;
  }
  if (items_.empty() && !order_.groups.empty()) concerns_.push_back(no_seeds(bootstrap_samples()));
}

/// Without a bootstrap there is neither a seed nor b: ordinary Monte Carlo with the same techniques
/// makes the same picture.
template <typename Space>
void ChainIntegrator<Space>::skip_preparation() {
  populations_.clear();
  RenderSettings own = settings_;
  own.max_depth = order_.sampler.max_depth;
  std::erase_if(own.aovs, is_chain_layer);
  unprepared_ = make_path_integrator(scene_, own, order_.monte_carlo);
}

template <typename Space>
Findings ChainIntegrator<Space>::findings() const {
  Findings found;
  found.concerns = concerns_;
  found.misses_light = misses_light_;
  if (unprepared_) {
    found.notes = {
        "too little time to look for light that chains start from: rendered by plain Monte Carlo "
        "(" +
        order_.monte_carlo.get_text("techniques") + ")"};
  } else if (!items_.empty()) {
    found.notes = {"Markov chains make all light"};
  }
  return found;
}

// ---------------------------------------------------------------- chains

template <typename Space>
std::uint64_t ChainIntegrator<Space>::items_in_round() const {
  return unprepared_ ? unprepared_->items_in_round() : items_.size();
}

template <typename Space>
std::uint64_t ChainIntegrator<Space>::steps(std::uint64_t sample, std::size_t chains) const {
  const double per_sample = view_.pixels / settings_.replicates / static_cast<double>(chains);
  const auto upto = [&](std::uint64_t samples) {
    return static_cast<std::uint64_t>(std::ceil(static_cast<double>(samples) * per_sample));
  };
  return std::max<std::uint64_t>(1, upto(sample + 1) - upto(sample));
}

/// Each mutation per pixel is deposited by itself, so that the film's bits do not depend on how
/// many a pass has.
template <typename Space>
void ChainIntegrator<Space>::run_item(std::uint64_t item, std::uint64_t first_sample,
                                      std::uint64_t samples, Film& film, Counters& counters) {
  if (unprepared_) {
    unprepared_->run_item(item, first_sample, samples, film, counters);
    return;
  }
  MeasuredPopulation& population = populations_[items_[item].population];
  Member& member = population.chains[items_[item].chain];
  typename Space::Walker walker(space_, scene_, order_.groups[population.group], view_);
  ChainFilmSink sink(film, population.replicate, view_.importance, walker.target(), counters);
  const double b = population.b.mean();
  const auto chains = static_cast<double>(population.chains.size());
  ChainStatistics statistics;
  walker.start(member);
  for (std::uint64_t sample = first_sample; sample < first_sample + samples; ++sample) {
    const std::uint64_t n =
        steps(sample, chains_per_[static_cast<std::size_t>(population.replicate)]);
    sink.begin(b * view_.area() / (static_cast<double>(n) * chains) / settings_.replicates,
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
  b /= settings_.replicates;
  return b > 0.0 && std::isfinite(b) ? b : 1.0;
}

template <typename Space>
std::vector<LayerSpec> ChainIntegrator<Space>::layers() const {
  std::vector<LayerSpec> specs;
  if (unprepared_) {
    specs = unprepared_->layers();
  } else {
    specs = light_layers(brightness());
    if (settings_.for_filters) add_box_layers(specs, make_filter(scene_.film().filter));
  }
  add_chain_layers(specs, settings_.aovs);
  return specs;
}

template <typename Space>
DevelopScale ChainIntegrator<Space>::develop_scale(const LayerSpec& layer, std::uint64_t samples,
                                                   std::optional<int> replicate) const {
  if (samples == 0) return 0.0;
  const double scale = 1.0 / static_cast<double>(samples);
  if (is_chain_layer(layer.name)) return scale;
  if (unprepared_) return unprepared_->develop_scale(layer, samples, replicate);
  return replicate ? scale * settings_.replicates : scale;
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
  if (unprepared_) return unprepared_->report();
  ChainReporter reporter(bootstrap_samples(), space_.moves());
  for (std::size_t g = 0; g < order_.groups.size(); ++g) {
    ChainReporter::OfGroup group(order_.groups[g]);
    for (const MeasuredPopulation& population : populations_) {
      if (population.group != g) continue;
      group.add_b(population.b.mean(), population.b.standard_error(), settings_.replicates);
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
    space_.save(archive, scene_, populations_[item.population].chains[item.chain]);
  }
}

template <typename Space>
void ChainIntegrator<Space>::load_state(InputArchive& archive, std::uint64_t samples) {
  std::uint64_t chains = 0;
  archive(chains);
  if (chains != items_.size()) {
    throw std::runtime_error("other chains are prepared than there were");
  }
  const auto replicates = static_cast<std::uint64_t>(settings_.replicates);
  // A pass that was cut short may have come as far as this; each sample has a step at least.
  const double most_steps =
      static_cast<double>(milestone_after(samples, replicates)) * (1.0 + view_.pixels);
  for (const Item& item : items_) {
    Member& member = populations_[item.population].chains[item.chain];
    space_.load(archive, scene_, member);
    space_.check(member, order_.groups[populations_[item.population].group], most_steps);
  }
  parallel_for(items_.size(), [&](std::size_t i) {
    const MeasuredPopulation& population = populations_[items_[i].population];
    space_.check_state(scene_, order_.groups[population.group], view_,
                       population.chains[items_[i].chain]);
  });
}

template <typename Space>
void ChainIntegrator<Space>::give_news(OutputArchive& archive, const WorkShare& share) {
  for (std::size_t i = 0; i < items_.size(); ++i) {
    if (!share.has(i)) continue;
    space_.save(archive, scene_, populations_[items_[i].population].chains[items_[i].chain]);
  }
}

template <typename Space>
void ChainIntegrator<Space>::take_news(InputArchive& archive, const WorkShare& share) {
  for (std::size_t i = 0; i < items_.size(); ++i) {
    if (!share.has(i)) continue;
    space_.load(archive, scene_, populations_[items_[i].population].chains[items_[i].chain]);
  }
}

template <typename Space>
std::uint64_t ChainIntegrator<Space>::memory_bytes() const {
  std::uint64_t bytes = 0;
  for (const MeasuredPopulation& population : populations_) {
    for (const Member& member : population.chains) bytes += member.memory_bytes();
  }
  return bytes;
}

}  // namespace ajar
