#include "integrator/metropolis/metropolis.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/archive.h"
#include "core/milestones.h"
#include "core/parallel_for.h"
#include "core/random_use.h"
#include "integrator/make_filter.h"
#include "integrator/metropolis/chain_film_sink.h"
#include "integrator/metropolis/chain_moves.h"
#include "integrator/metropolis/chain_report.h"
#include "integrator/metropolis/heuristics.h"
#include "integrator/metropolis/population.h"
#include "integrator/montecarlo/blind_spots.h"
#include "integrator/montecarlo/path_family.h"
#include "integrator/montecarlo/path_parameters.h"
#include "mcmc/primary/primary_runner.h"

namespace ajar {

namespace {

/// As pbrt has them, over all depths and replicates.
constexpr const char* kBootstrapSamples = "100000";
constexpr const char* kChains = "1000";

struct MeasuredPopulation : Population {
  Moments b;  ///< I over the bootstrap: its mean is ∫ I
};

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
class MetropolisIntegrator final : public Integrator {
 public:
  MetropolisIntegrator(ChainKind kind, const Scene& scene, const RenderSettings& settings,
                       const Parameters& parameters)
      : scene_(scene),
        settings_(settings),
        moves_(parameters),
        view_(view_of(scene, settings)),
        sampler_(sampler_of(settings, parameters)),
        groups_(make_path_groups(
            kind, sampler_,
            kind == ChainKind::WholePath ? parameters.get_int("roulette-start") : 0)),
        bootstrap_(static_cast<std::uint64_t>(parameters.get_int("bootstrap"))),
        chains_(static_cast<std::size_t>(parameters.get_int("chains"))),
        monte_carlo_(path_family_parameters(path_family_defaults("bdpt")),
                     {{"techniques", parameters.get_text("techniques")},
                      {"heuristic", parameters.get_text("heuristic")}}),
        concerns_(blind_spots(scene, settings, sampler_)) {}

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
  struct Item {
    std::size_t population;
    std::size_t chain;
  };

  static PathSamplerSettings sampler_of(const RenderSettings& settings,
                                        const Parameters& parameters);
  void seed();
  /// Mutations of a chain of a replicate that has `chains` of them, from sample `sample` to the
  /// next.
  std::uint64_t steps(std::uint64_t sample, std::size_t chains) const;
  /// b over all depths, the mean of the replicates.
  double brightness() const;
  std::uint64_t bootstrap_samples() const;
  template <typename A>
  void serialize_news(A& archive, const WorkShare& share);

  const Scene& scene_;
  RenderSettings settings_;
  ChainMoves moves_;
  ChainView view_;
  PathSamplerSettings sampler_;
  std::vector<PathGroup> groups_;
  std::uint64_t bootstrap_;
  std::size_t chains_;
  Parameters monte_carlo_;  ///< of `unprepared_`
  std::vector<Warning> concerns_;
  bool misses_light_ = !concerns_.empty();

  std::vector<MeasuredPopulation> populations_;
  std::vector<SampleBlock> blocks_;         ///< of the bootstrap
  std::vector<Item> items_;                 ///< one per chain
  std::vector<std::size_t> chains_per_;     ///< replicate
  std::unique_ptr<Integrator> unprepared_;  ///< renders if there was no time for a bootstrap
};

PathSamplerSettings MetropolisIntegrator::sampler_of(const RenderSettings& settings,
                                                     const Parameters& parameters) {
  const Vec2i size = settings.crop.size() + Vec2i(1, 1);
  PathSamplerSettings sampler;
  sampler.techniques = techniques_of_chains(parameters);
  sampler.heuristic = heuristic_of(parameters);
  sampler.min_depth = settings.min_depth;
  sampler.max_depth = std::min(settings.max_depth, MetropolisHeuristics::kMostEdges);
  sampler.light_paths_per_pixel =
      static_cast<double>(size.x) * size.y /
      (static_cast<double>(settings.resolution.x) * settings.resolution.y);
  return sampler;
}

// ---------------------------------------------------------------- bootstrap

PreparationRound MetropolisIntegrator::begin_preparation(int round) {
  if (round == 0) {
    populations_ =
        make_populations<MeasuredPopulation>(groups_, settings_.replicates, settings_.seed);
    blocks_ = share_bootstrap(populations_, groups_, settings_.replicates, bootstrap_);
    return {.items = blocks_.size()};
  }
  seed();
  return {};
}

void MetropolisIntegrator::prepare_item(int /*round*/, std::uint64_t item, Counters& counters) {
  MeasuredPopulation& population = populations_[blocks_[item].owner];
  sample_bootstrap(population, blocks_[item],
                   *make_path_target(scene_, groups_[population.group], view_), counters);
}

void MetropolisIntegrator::seed() {
  for (MeasuredPopulation& population : populations_) {
    population.b = bootstrap_moments(population.weights);
  }
  const auto replicates = static_cast<std::size_t>(settings_.replicates);
  seed_populations(populations_, groups_, std::max<std::size_t>(1, chains_ / replicates),
                   [](const MeasuredPopulation& population) { return population.b.mean(); });
  chains_per_.assign(replicates, 0);
  for (std::size_t p = 0; p < populations_.size(); ++p) {
    const std::size_t chains = populations_[p].chains.size();
    for (std::size_t c = 0; c < chains; ++c) items_.push_back({p, c});
    chains_per_[static_cast<std::size_t>(populations_[p].replicate)] += chains;
  }
  if (items_.empty() && !groups_.empty()) concerns_.push_back(no_seeds(bootstrap_samples()));
}

/// Without a bootstrap there is neither a seed nor b: ordinary Monte Carlo with the same techniques
/// makes the same picture.
void MetropolisIntegrator::skip_preparation() {
  populations_.clear();
  RenderSettings own = settings_;
  own.max_depth = sampler_.max_depth;
  std::erase_if(own.aovs, is_chain_layer);
  unprepared_ = make_path_integrator(scene_, own, monte_carlo_);
}

Findings MetropolisIntegrator::findings() const {
  Findings found;
  found.concerns = concerns_;
  found.misses_light = misses_light_;
  if (unprepared_) {
    found.notes = {
        "too little time to look for light that chains start from: rendered by plain Monte Carlo "
        "(" +
        monte_carlo_.get_text("techniques") + ")"};
  } else if (!items_.empty()) {
    found.notes = {"Markov chains make all light"};
  }
  return found;
}

// ---------------------------------------------------------------- chains

std::uint64_t MetropolisIntegrator::items_in_round() const {
  return unprepared_ ? unprepared_->items_in_round() : items_.size();
}

std::uint64_t MetropolisIntegrator::steps(std::uint64_t sample, std::size_t chains) const {
  const double per_sample = view_.pixels / settings_.replicates / static_cast<double>(chains);
  const auto upto = [&](std::uint64_t samples) {
    return static_cast<std::uint64_t>(std::ceil(static_cast<double>(samples) * per_sample));
  };
  return std::max<std::uint64_t>(1, upto(sample + 1) - upto(sample));
}

/// Each mutation per pixel is deposited by itself, so that the film's bits do not depend on how
/// many a pass has.
void MetropolisIntegrator::run_item(std::uint64_t item, std::uint64_t first_sample,
                                    std::uint64_t samples, Film& film, Counters& counters) {
  if (unprepared_) {
    unprepared_->run_item(item, first_sample, samples, film, counters);
    return;
  }
  MeasuredPopulation& population = populations_[items_[item].population];
  MemberChain& member = population.chains[items_[item].chain];
  const PathGroup& group = groups_[population.group];
  const auto target = make_path_target(scene_, group, view_);
  PrimaryRunner runner(moves_.settings, *moves_.mutation, group.shape, *target);
  ChainFilmSink sink(film, population.replicate, view_.importance, *target, counters);
  const double b = population.b.mean();
  const auto chains = static_cast<double>(population.chains.size());
  ChainStatistics statistics;
  runner.start(member.chain);
  for (std::uint64_t sample = first_sample; sample < first_sample + samples; ++sample) {
    const std::uint64_t n =
        steps(sample, chains_per_[static_cast<std::size_t>(population.replicate)]);
    sink.begin(b * view_.area() / (static_cast<double>(n) * chains) / settings_.replicates,
               member.record.by_technique.empty() ? nullptr : &member.record.by_technique);
    const ChainStatistics of_sample = runner.go_on(
        member.chain, n, sink, moves_.mis_large_steps ? std::optional(b) : std::nullopt);
    member.record.statistics += of_sample;
    statistics += of_sample;
  }
  count_steps(member, statistics, *target, counters);
}

// ---------------------------------------------------------------- film

double MetropolisIntegrator::brightness() const {
  double b = 0.0;
  for (const MeasuredPopulation& population : populations_) b += population.b.mean();
  b /= settings_.replicates;
  return b > 0.0 && std::isfinite(b) ? b : 1.0;
}

std::vector<LayerSpec> MetropolisIntegrator::layers() const {
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

DevelopScale MetropolisIntegrator::develop_scale(const LayerSpec& layer, std::uint64_t samples,
                                                 std::optional<int> replicate) const {
  if (samples == 0) return 0.0;
  const double scale = 1.0 / static_cast<double>(samples);
  if (is_chain_layer(layer.name)) return scale;
  if (unprepared_) return unprepared_->develop_scale(layer, samples, replicate);
  return replicate ? scale * settings_.replicates : scale;
}

// ---------------------------------------------------------------- report, state

std::uint64_t MetropolisIntegrator::bootstrap_samples() const {
  std::uint64_t samples = 0;
  for (const MeasuredPopulation& population : populations_) samples += population.b.count;
  return samples;
}

MethodReport MetropolisIntegrator::report() const {
  if (unprepared_) return unprepared_->report();
  ChainReporter reporter(bootstrap_samples(), primary_moves());
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    ChainReporter::OfGroup group(groups_[g]);
    for (const MeasuredPopulation& population : populations_) {
      if (population.group != g) continue;
      group.add_b(population.b.mean(), population.b.standard_error(), settings_.replicates);
      for (const MemberChain& member : population.chains) group.add_chain(member.record);
    }
    reporter.add(std::move(group));
  }
  return reporter.report();
}

void MetropolisIntegrator::save_state(OutputArchive& archive) const {
  archive(static_cast<std::uint64_t>(items_.size()));
  for (const Item& item : items_) archive(populations_[item.population].chains[item.chain]);
}

void MetropolisIntegrator::load_state(InputArchive& archive, std::uint64_t samples) {
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
    MemberChain& member = populations_[item.population].chains[item.chain];
    archive(member);
    check_member(member, groups_[populations_[item.population].group], most_steps);
  }
  parallel_for(items_.size(), [&](std::size_t i) {
    const MeasuredPopulation& population = populations_[items_[i].population];
    check_state(population.chains[items_[i].chain],
                *make_path_target(scene_, groups_[population.group], view_));
  });
}

template <typename A>
void MetropolisIntegrator::serialize_news(A& archive, const WorkShare& share) {
  for (std::size_t i = 0; i < items_.size(); ++i) {
    if (share.has(i)) archive(populations_[items_[i].population].chains[items_[i].chain]);
  }
}

void MetropolisIntegrator::give_news(OutputArchive& archive, const WorkShare& share) {
  serialize_news(archive, share);
}

void MetropolisIntegrator::take_news(InputArchive& archive, const WorkShare& share) {
  serialize_news(archive, share);
}

std::uint64_t MetropolisIntegrator::memory_bytes() const {
  std::uint64_t bytes = 0;
  for (const MeasuredPopulation& population : populations_) {
    for (const MemberChain& member : population.chains) bytes += member.memory_bytes();
  }
  return bytes;
}

}  // namespace

std::vector<ParameterSpec> metropolis_parameters(ChainKind kind) {
  std::vector<ParameterSpec> specs = {techniques_parameter("bdpt"), heuristic_parameter()};
  specs.back().expert = true;
  for (ParameterSpec& spec : ChainMoves::parameters({})) specs.push_back(std::move(spec));
  specs.push_back({.name = "bootstrap",
                   .type = ParameterType::Int,
                   .default_value = kBootstrapSamples,
                   .unit = "samples",
                   .help = "independent paths, over all depths and replicates, that say how bright "
                           "the picture is and where chains start",
                   .choices = {},
                   .minimum = 1000,
                   .maximum = 100000000});
  specs.push_back({.name = "chains",
                   .type = ParameterType::Int,
                   .default_value = kChains,
                   .unit = "",
                   .help = "number of Markov chains",
                   .choices = {},
                   .minimum = 1,
                   .maximum = 1000000});
  if (kind == ChainKind::WholePath) {
    specs.push_back(roulette_start_parameter("3"));
    specs.back().expert = true;
  }
  return specs;
}

std::unique_ptr<Integrator> make_metropolis_integrator(ChainKind kind, const Scene& scene,
                                                       const RenderSettings& settings,
                                                       const Parameters& parameters) {
  return std::make_unique<MetropolisIntegrator>(kind, scene, settings, parameters);
}

}  // namespace ajar
