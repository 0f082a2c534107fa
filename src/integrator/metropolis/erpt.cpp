#include "integrator/metropolis/erpt.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/archive.h"
#include "core/inactive_parameters.h"
#include "core/random_use.h"
#include "integrator/metropolis/chain_film_sink.h"
#include "integrator/metropolis/chain_method.h"
#include "integrator/metropolis/chain_report.h"
#include "integrator/metropolis/heuristics.h"
#include "integrator/metropolis/path_space.h"
#include "integrator/metropolis/population.h"
#include "integrator/metropolis/primary_space.h"
#include "integrator/montecarlo/path_parameters.h"
#include "mcmc/counter_random.h"

namespace ajar {

namespace {

/// A sample per pixel is a mutation per pixel, about.
///
///     bootstrap   gives e_d, the mean of what a sample brings: any would do;
///     render      a sample that brings e starts e/e_d chains on average, a whole number of them,
///                 each of as many steps, and each chain brings e_d in equal parts. Beyond a number
///                 of chains each brings more instead.
///
/// A chain leaves the distribution of its start as it is, so each of its states stands for the
/// sample as well as the sample itself, and the picture is unbiased.
template <typename Space>
class EnergyRedistribution final : public ChainMethod {
 public:
  EnergyRedistribution(const Scene& scene, const RenderSettings& settings, ChainOrder order,
                       const Parameters& parameters, Space space)
      : ChainMethod(scene, settings, std::move(order)),
        length_(static_cast<std::uint64_t>(parameters.get_int("chain-length"))),
        most_chains_(parameters.get_int("most-chains")),
        space_(std::move(space)) {}

  PreparationRound begin_preparation(int round) override;
  void prepare_item(int round, std::uint64_t item, Counters& counters) override;
  std::uint64_t items_in_round() const override;
  void run_item(std::uint64_t item, std::uint64_t first_sample, std::uint64_t samples, Film& film,
                Counters& counters) override;
  MethodReport report() const override;

  void save_state(OutputArchive& archive) const override;
  void load_state(InputArchive& archive, std::uint64_t samples) override;
  void export_delta(OutputArchive& archive, const WorkSlice& slice) override;
  void import_delta(InputArchive& archive, const WorkSlice& slice) override;

 private:
  using Measured = PopulationOf<typename Space::Member>;
  /// A part of the samples of a replicate, and what has become of their chains.
  struct Item {
    int replicate = 0;
    std::uint64_t seed = 0;
    std::uint64_t chains = 0;
    ChainRecord record;
    template <typename Archive>
    void serialize(Archive& archive) {
      archive(chains, record);
    }
  };

  ChainProblem problem() const { return {scene(), groups().front(), view(), order().part}; }
  double brightness() const override { return mean_; }
  bool has_chains() const override { return mean_ > 0.0; }
  void make_items();
  /// Independent samples of an item, from mutation per pixel `sample` to the next.
  std::uint64_t independent_samples(std::uint64_t sample) const;
  /// Chains of a sample, and what each brings.
  struct Spread {
    std::uint64_t chains;
    double energy;
  };
  Spread spread(double energy, double u) const;

  std::uint64_t length_;
  double most_chains_;
  Space space_;
  std::vector<Measured> populations_;  ///< populations of the bootstrap: one per replicate
  std::vector<SampleBlock> blocks_;
  std::vector<Moments> b_;  ///< by replicate
  double mean_ = 0.0;       ///< over all of them: e_d
  std::uint64_t items_per_replicate_ = 1;
  std::vector<Item> items_;
};

// ---------------------------------------------------------------- bootstrap

template <typename Space>
PreparationRound EnergyRedistribution<Space>::begin_preparation(int round) {
  if (round == 0) {
    populations_ = make_populations<Measured>(groups(), settings().replicates, settings().seed);
    blocks_ = share_bootstrap(populations_, groups(), settings().replicates, order().bootstrap);
    return {.items = blocks_.size(), .effort = bootstrap_effort()};
  }
  std::uint64_t samples = 0;
  for (Measured& population : populations_) {
    b_.push_back(bootstrap_moments(population.weights));
    mean_ += b_.back().mean() / settings().replicates;
    samples += b_.back().count;
    population.weights = {};
  }
  if (!(mean_ > 0.0) && !groups().empty()) add_concern(no_seeds(samples));
  make_items();
  return {};
}

template <typename Space>
void EnergyRedistribution<Space>::prepare_item(int /*round*/, std::uint64_t item,
                                               Counters& counters) {
  Measured& population = populations_[blocks_[item].owner];
  sample_bootstrap(population, blocks_[item], *make_seed_target(problem()), counters);
}

template <typename Space>
void EnergyRedistribution<Space>::make_items() {
  // Each has a sample per mutation per pixel at least.
  const double samples = view().pixels / settings().replicates / static_cast<double>(length_);
  items_per_replicate_ =
      static_cast<std::uint64_t>(std::clamp(samples, 1.0, MetropolisHeuristics::kMostItems));
  for (int replicate = 0; replicate < settings().replicates && !groups().empty(); ++replicate) {
    for (std::uint64_t i = 0; i < items_per_replicate_; ++i) {
      Item& item = items_.emplace_back();
      item.replicate = replicate;
      item.seed = hash_numbers(settings().seed, RandomUse::EnergySamples, replicate, i);
    }
  }
}

// ---------------------------------------------------------------- samples and their chains

template <typename Space>
std::uint64_t EnergyRedistribution<Space>::items_in_round() const {
  return unprepared() != nullptr ? unprepared()->items_in_round() : items_.size();
}

template <typename Space>
std::uint64_t EnergyRedistribution<Space>::independent_samples(std::uint64_t sample) const {
  const double per_sample =
      view().pixels / settings().replicates /
      (static_cast<double>(length_) * static_cast<double>(items_per_replicate_));
  const auto upto = [&](std::uint64_t samples) {
    return static_cast<std::uint64_t>(std::ceil(static_cast<double>(samples) * per_sample));
  };
  return std::max<std::uint64_t>(1, upto(sample + 1) - upto(sample));
}

template <typename Space>
typename EnergyRedistribution<Space>::Spread EnergyRedistribution<Space>::spread(double energy,
                                                                                 double u) const {
  if (!(energy > 0.0) || !std::isfinite(energy)) return {0, 0.0};
  // A bootstrap that found nothing says nothing of what there is.
  const double share = mean_ > 0.0 ? mean_ : energy;
  const double chains = energy / share;
  if (chains > most_chains_) {
    return {static_cast<std::uint64_t>(most_chains_), energy / most_chains_};
  }
  return {static_cast<std::uint64_t>(chains + u), share};
}

template <typename Space>
void EnergyRedistribution<Space>::run_item(std::uint64_t item, std::uint64_t first_sample,
                                           std::uint64_t samples, Film& film, Counters& counters) {
  if (unprepared() != nullptr) {
    unprepared()->run_item(item, first_sample, samples, film, counters);
    return;
  }
  Item& own = items_[item];
  const auto target = make_seed_target(problem());
  typename Space::Walker walker(space_, problem(), own.replicate);
  ChainFilmSink sink(film, own.replicate, view().importance, walker.target(), counters, nullptr,
                     order().part);
  SplatBuffer splats;
  ChainStatistics statistics;
  for (std::uint64_t sample = first_sample; sample < first_sample + samples; ++sample) {
    const std::uint64_t count = independent_samples(sample);
    const double scale = view().area() / settings().replicates /
                         (static_cast<double>(count) * static_cast<double>(items_per_replicate_) *
                          static_cast<double>(length_));
    SampleOfChains start{hash_numbers(own.seed, sample), 0, 0.0};
    ChainStatistics of_sample;
    for (; start.index < count; ++start.index) {
      BootstrapSource numbers(start.seed, start.index);
      splats.clear();
      start.weight = target->evaluate(numbers, Change{}, splats);
      target->rejected();
      const Spread chains = spread(
          start.weight, to_unit_double(hash_numbers(start.seed, RandomUse::Seeds, start.index)));
      sink.begin(scale * chains.energy, nullptr);
      for (std::uint64_t number = 0; number < chains.chains; ++number) {
        auto member = space_.start(problem(), start, number);
        if (!member) continue;
        walker.start(*member);
        of_sample += walker.go_on(*member, length_, sink, mean_);
        ++own.chains;
      }
    }
    own.record.statistics += of_sample;
    statistics += of_sample;
  }
  count_steps(own.seed, statistics, walker.ray_counts(), counters);
  counters.add_rays(target->ray_counts());
}

// ---------------------------------------------------------------- report, state

template <typename Space>
MethodReport EnergyRedistribution<Space>::report() const {
  if (unprepared() != nullptr) return unprepared()->report();
  std::uint64_t samples = 0;
  for (const Moments& b : b_) samples += b.count;
  ChainReporter reporter(samples);
  std::uint64_t chains = 0;
  if (!groups().empty()) {
    ChainReporter::OfGroup group(groups().front(), space_.moves());
    for (const Moments& b : b_) {
      group.add_b(b.mean(), b.standard_error(), settings().replicates);
    }
    for (const Item& item : items_) {
      group.add_retired(item.record);
      chains += item.chains;
    }
    reporter.add(std::move(group));
  }
  MethodReport report = reporter.report();
  report["chains"] = chains;
  return report;
}

template <typename Space>
void EnergyRedistribution<Space>::save_state(OutputArchive& archive) const {
  archive(static_cast<std::uint64_t>(items_.size()));
  for (const Item& item : items_) archive(item);
}

template <typename Space>
void EnergyRedistribution<Space>::load_state(InputArchive& archive, std::uint64_t /*samples*/) {
  std::uint64_t items = 0;
  archive(items);
  if (items != items_.size())
    throw std::runtime_error("other samples are prepared than there were");
  for (Item& item : items_) {
    archive(item);
    check_record(item.record, groups().front(), space_.moves().size());
  }
}

template <typename Space>
void EnergyRedistribution<Space>::export_delta(OutputArchive& archive, const WorkSlice& slice) {
  for (std::size_t i = 0; i < items_.size(); ++i) {
    if (slice.has(i)) archive(items_[i]);
  }
}

template <typename Space>
void EnergyRedistribution<Space>::import_delta(InputArchive& archive, const WorkSlice& slice) {
  for (std::size_t i = 0; i < items_.size(); ++i) {
    if (slice.has(i)) archive(items_[i]);
  }
}

/// Chains as short as that need no fresh paths.
const ChainMoves::Defaults kMoves{.large_step = "0.001"};

/// A parameter of chains of one kind.
ParameterSpec only_with(const char* chain, ParameterSpec spec) {
  spec.depends_on = "chain";
  spec.matters_for = {chain};
  return spec;
}

}  // namespace

std::vector<ParameterSpec> erpt_parameters() {
  std::vector<ParameterSpec> specs = {
      {.name = "chain",
       .type = ParameterType::Choice,
       .default_value = "mlt",
       .unit = "",
       .help =
           "how chains walk: as those of mlt, in path space, or of pssmlt, which move the numbers "
           "of a sample",
       .choices = {"mlt", "pssmlt"}}};
  specs.push_back({.name = "chain-length",
                   .type = ParameterType::Int,
                   .default_value = "10",
                   .unit = "mutations",
                   .help = "of each chain; a sample starts one on average",
                   .choices = {},
                   .minimum = 1,
                   .maximum = 1000000});
  specs.push_back({.name = "most-chains",
                   .type = ParameterType::Int,
                   .default_value = "16",
                   .unit = "",
                   .help = "that start from a sample; where it brings more light, they bring more",
                   .choices = {},
                   .minimum = 1,
                   .maximum = 1000000});
  specs.back().expert = true;
  for (ParameterSpec& spec : path_mutation_parameters("bidirectional")) {
    specs.push_back(only_with("mlt", std::move(spec)));
  }
  for (ParameterSpec& spec : ChainMoves::parameters(kMoves)) {
    if (spec.name == "mutation" || spec.name == "sigma") {
      specs.push_back(only_with("pssmlt", std::move(spec)));
    }
  }
  specs.push_back(bootstrap_parameter());
  specs.push_back(roulette_start_parameter(3));
  specs.back().expert = true;
  return specs;
}

std::unique_ptr<Integrator> make_erpt_integrator(const Scene& scene, const RenderSettings& settings,
                                                 const Parameters& parameters,
                                                 const ChainWeight* part) {
  refuse_inactive(erpt_parameters(), parameters);
  ChainOrder order = chain_order(settings, parameters, {{"techniques", "bdpt"}});
  order.part = part;
  const bool of_paths = parameters.get_text("chain") == "mlt";
  order.groups = make_path_groups(scene, of_paths ? ChainSpace::Erpt : ChainSpace::Pssmlt,
                                  order.sampler, parameters.get_int("roulette-start"));
  if (of_paths) {
    return std::make_unique<EnergyRedistribution<PathSpace>>(scene, settings, std::move(order),
                                                             parameters, PathSpace(parameters));
  }
  const Parameters moves(
      ChainMoves::parameters(kMoves),
      {{"mutation", parameters.get_text("mutation")}, {"sigma", parameters.get_text("sigma")}});
  return std::make_unique<EnergyRedistribution<PrimarySpace>>(
      scene, settings, std::move(order), parameters, PrimarySpace(ChainMoves(moves)));
}

}  // namespace ajar
