#include "integrator/chain_family.h"

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "image/image_file.h"
#include "image/importance_map.h"
#include "image/make_filter.h"
#include "integrator/chain_population.h"
#include "integrator/g_buffer.h"
#include "integrator/path_family.h"
#include "integrator/path_target.h"
#include "mcmc/bootstrap.h"
#include "mcmc/bootstrap_source.h"
#include "mcmc/chain_runner.h"
#include "mcmc/make_mutation.h"

namespace ajar {

namespace {

constexpr int kDirectDepth = 2;
constexpr int kPilotSamples = 2;
constexpr std::uint64_t kSamplesPerBlock = 512;
constexpr int kMaxChainEdges = 1000;
const std::string kDensity = "density";
const std::string kAcceptance = "acceptance";

enum class Direct { Omc, Chain, None };

Direct direct_of(const std::string& text) {
  if (text == "omc") return Direct::Omc;
  return text == "chain" ? Direct::Chain : Direct::None;
}

bool asks_for(const std::vector<std::string>& aovs, const std::string& name) {
  return std::find(aovs.begin(), aovs.end(), name) != aovs.end();
}

/// Puts what chains deposit on the film.
class FilmSink final : public DepositSink {
 public:
  FilmSink(Film& film, int replicate, const ImportanceMap& importance, const PathTarget& target,
           Counters& counters)
      : film_(film),
        light_{film.layer("direct"), film.layer("indirect")},
        density_(film.layer(kDensity)),
        acceptance_(film.layer(kAcceptance)),
        replicate_(replicate),
        importance_(importance),
        target_(target),
        counters_(counters) {}

  /// `scale` multiplies what is deposited; what is `proposed` is counted in `by_technique`.
  void begin(double scale, std::vector<ChainStatistics::Kind>* by_technique) {
    scale_ = scale;
    by_technique_ = by_technique;
  }

  void deposit(std::span<const Splat> splats, double factor) override {
    for (const Splat& splat : splats) {
      const Spectrum value = splat.value * static_cast<float>(factor * scale_);
      if (!film_.splat(light_[static_cast<std::size_t>(splat.layer)], replicate_, splat.raster,
                       value)) {
        ++counters_.discarded_infinite;
      }
      if (density_ >= 0) {
        const double share = factor * static_cast<double>(luminance(splat.value)) *
                             static_cast<double>(importance_(splat.raster));
        film_.splat(density_, 0, splat.raster, Spectrum(static_cast<float>(share)));
      }
    }
  }

  void proposed(std::span<const Splat> current, double acceptance) override {
    if (by_technique_ != nullptr && target_.technique() != nullptr) {
      auto& kind = (*by_technique_)[target_.technique()->number];
      ++kind.proposals;
      kind.acceptances += acceptance;
    }
    if (acceptance_ >= 0 && !current.empty()) {
      film_.splat(acceptance_, 0, current.front().raster,
                  Spectrum(static_cast<float>(acceptance), 1.F, 0.F));
    }
  }

 private:
  Film& film_;
  std::array<int, 2> light_;
  int density_;
  int acceptance_;
  int replicate_;
  const ImportanceMap& importance_;
  const PathTarget& target_;
  Counters& counters_;
  double scale_ = 1.0;
  std::vector<ChainStatistics::Kind>* by_technique_ = nullptr;
};

class ChainIntegrator final : public Integrator {
 public:
  ChainIntegrator(ChainKind kind, const Scene& scene, const RenderSettings& settings,
                  const Parameters& parameters);

  std::uint64_t begin_preparation(int round) override;
  void prepare_item(int round, std::uint64_t item, Counters& counters) override;
  std::vector<std::string> concerns() const override { return concerns_; }

  std::vector<LayerSpec> layers() const override;
  std::uint64_t items_in_pass() const override;
  void begin_pass(std::uint64_t first_sample, std::uint64_t samples) override;
  void run_item(std::uint64_t item, std::uint64_t first_sample, std::uint64_t samples, Film& film,
                Counters& counters) override;
  double develop_scale(const LayerSpec& layer, std::uint64_t samples,
                       std::optional<int> replicate) const override;
  std::optional<ChainReport> chain_report() const override;

 private:
  /// The rounds of the preparation.
  enum class Stage {
    Pilot,     ///< a picture for the importance map
    Trial,     ///< which techniques carry the light of a depth
    Bootstrap  ///< seeds for the chains
  };
  /// One block of samples of one group (trial) or population (bootstrap).
  struct SampleBlock {
    std::size_t owner;
    std::uint64_t first;
    std::uint64_t last;
  };
  /// A chain, or the plain samples of a population without seeds.
  struct ChainItem {
    std::size_t population;
    std::size_t chain;
  };

  void make_groups(const Parameters& parameters);
  void begin_pilot(const Parameters& parameters);
  void end_pilot();
  std::uint64_t begin(Stage stage);
  void end(Stage stage);
  void add_blocks(std::size_t owner, std::uint64_t samples);
  /// The share of all bootstrap samples that a group gets: long paths carry little light and cost
  /// much.
  double bootstrap_share(const PathGroup& group) const;
  void run_trial(std::uint64_t item, Counters& counters);
  void end_trial();
  void begin_bootstrap();
  void run_bootstrap(std::uint64_t item, Counters& counters);
  void end_bootstrap();
  void seed_replicate(int replicate);
  void add_concerns();
  std::unique_ptr<PathTarget> make_target(const PathGroup& group) const;
  void run_chain(const ChainItem& item, std::uint64_t samples, Film& film, Counters& counters);
  void run_plain(ChainPopulation& population, std::uint64_t samples, Film& film,
                 Counters& counters);
  std::uint64_t pixels() const {
    const Vec2i size = settings_.crop.size() + Vec2i(1, 1);
    return static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y);
  }
  /// Direct samples per pixel that belong to the first `mutations` mutations per pixel.
  std::uint64_t direct_samples(std::uint64_t mutations) const;
  /// Mutations of each chain of a replicate up to `samples` mutations per pixel.
  std::uint64_t steps_until(std::uint64_t samples, std::size_t chains) const;
  std::size_t chains_in(int replicate) const {
    return chain_counts_[static_cast<std::size_t>(replicate)];
  }

  ChainKind kind_;
  const Scene& scene_;
  RenderSettings settings_;
  TechniqueSet techniques_;
  Direct direct_;
  double direct_share_;
  bool mis_large_steps_;
  std::uint64_t bootstrap_;
  std::uint64_t wanted_chains_;
  ChainSettings chain_settings_;
  std::unique_ptr<Mutation> mutation_;
  ChainView view_;
  std::vector<PathGroup> groups_;
  std::vector<ChainPopulation> populations_;
  std::vector<std::size_t> chain_counts_;  ///< per replicate
  std::vector<Stage> stages_;
  std::vector<SampleBlock> blocks_;               ///< of the current stage
  std::vector<std::vector<double>> trial_light_;  ///< per block, by technique
  std::vector<ChainItem> chain_items_;
  // During the current pass:
  std::vector<double> b_;      ///< of each population
  double later_weight_ = 0.0;  ///< of samples after the bootstrap, in all estimates of b
  std::vector<std::string> concerns_;

  std::unique_ptr<Integrator> direct_light_;  ///< null if chains do it or nobody
  std::unique_ptr<Integrator> pilot_;         ///< null if the importance needs none
  std::unique_ptr<Film> pilot_film_;
  std::uint64_t first_sample_ = 0;
};

ChainIntegrator::ChainIntegrator(ChainKind kind, const Scene& scene, const RenderSettings& settings,
                                 const Parameters& parameters)
    : kind_(kind),
      scene_(scene),
      settings_(settings),
      techniques_(TechniqueSet::parse(parameters.get_text("techniques"))),
      direct_(direct_of(parameters.get_text("direct"))),
      direct_share_(parameters.get_float("direct-samples")),
      mis_large_steps_(parameters.get_bool("mis-large-steps")),
      bootstrap_(static_cast<std::uint64_t>(parameters.get_int("bootstrap"))),
      wanted_chains_(static_cast<std::uint64_t>(parameters.get_int("chains"))),
      mutation_(make_mutation(parameters.get_text("mutation"), parameters.get_float("sigma"))) {
  settings_.max_depth = std::min(settings_.max_depth, kMaxChainEdges);
  chain_settings_.probabilities = {parameters.get_float("large-step"),
                                   parameters.get_float("camera-steps"),
                                   parameters.get_float("light-steps")};
  // Half moves keep the technique, so that the other half need not be traced again.
  chain_settings_.connection = {false, false};
  // Chains have no numbers for further tries, and would gain nothing from fewer.
  if (!techniques_.tries_once()) {
    throw UsageError("techniques: Markov chains try each technique once, so leave out counts: " +
                     parameters.get_text("techniques"));
  }
  if (chain_settings_.probabilities.camera_half + chain_settings_.probabilities.light_half > 1.0) {
    throw UsageError(
        "camera-steps and light-steps are shares of the small steps: together at most 1");
  }
  const Vec2 beyond = make_filter(scene.film().filter).radius() - Vec2(0.5F, 0.5F);
  view_.low = Vec2(settings.crop.min) - beyond;
  view_.size = Vec2(settings.crop.size() + Vec2i(1, 1)) + beyond * 2.F;
  make_groups(parameters);
  if (direct_ == Direct::Omc && settings_.min_depth <= kDirectDepth) {
    RenderSettings direct = settings_;
    direct.max_depth = std::min(direct.max_depth, kDirectDepth);
    std::erase_if(direct.aovs, [](const std::string& name) {
      return name == kDensity || name == kAcceptance || name == "techniques";
    });
    const auto specs = path_family_parameters({.techniques = parameters.get_text("techniques")});
    direct_light_ = make_path_integrator(
        scene, direct, Parameters(specs, {{"heuristic", parameters.get_text("heuristic")}}));
  }
  begin_pilot(parameters);
  if (pilot_) stages_.push_back(Stage::Pilot);
  if (kind_ == ChainKind::OnePath) stages_.push_back(Stage::Trial);
  stages_.push_back(Stage::Bootstrap);
}

void ChainIntegrator::make_groups(const Parameters& parameters) {
  PathSamplerSettings sampler;
  sampler.techniques = techniques_;
  sampler.heuristic =
      parameters.get_text("heuristic") == "power" ? Heuristic::Power : Heuristic::Balance;
  sampler.min_depth =
      direct_ == Direct::Chain ? settings_.min_depth : std::max(settings_.min_depth, 3);
  sampler.max_depth = settings_.max_depth;
  sampler.light_paths_per_pixel =
      view_.area() / (static_cast<double>(settings_.resolution.x) * settings_.resolution.y);
  if (sampler.min_depth > sampler.max_depth) return;
  if (kind_ == ChainKind::WholePath) {
    sampler.roulette_start = parameters.get_int("roulette-start");
    groups_.push_back({0,
                       sampler,
                       TechniqueChoice(techniques_, 0),
                       {sampler.max_depth + 1, sampler.max_depth + 1}});
    return;
  }
  // A path of given depth gains nothing from ending early.
  sampler.roulette_start = kMaxChainEdges + 1;
  for (int depth = sampler.min_depth; depth <= settings_.max_depth; ++depth) {
    const TechniqueChoice choice(techniques_, depth);
    if (choice.empty()) continue;
    PathSamplerSettings own = sampler;
    own.min_depth = depth;
    own.max_depth = depth;
    groups_.push_back({depth, own, choice, {depth + 1, depth + 1}});
  }
}

void ChainIntegrator::begin_pilot(const Parameters& parameters) {
  const std::string& text = parameters.get_text("importance");
  if (text == "uniform") return;
  if (text == "relative") {
    RenderSettings pilot = settings_;
    pilot.replicates = 1;
    pilot.aovs.clear();
    pilot.seed = hash_numbers(settings_.seed, 0x91107ULL);
    const auto specs = path_family_parameters({.techniques = parameters.get_text("techniques")});
    pilot_ = make_path_integrator(scene_, pilot, Parameters(specs, {}));
    return;
  }
  const Image image = read_image(text);
  const Vec2i size = settings_.crop.size() + Vec2i(1, 1);
  const bool whole =
      image.width == settings_.resolution.x && image.height == settings_.resolution.y;
  if (!whole && (image.width != size.x || image.height != size.y)) {
    throw UsageError("importance: " + text + " has " + std::to_string(image.width) + "x" +
                     std::to_string(image.height) + " pixels, the picture " +
                     std::to_string(settings_.resolution.x) + "x" +
                     std::to_string(settings_.resolution.y));
  }
  const std::vector<float> colors = image.rgb();
  std::vector<float> weights(colors.size() / 3);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weights[i] = luminance(Spectrum(colors[3 * i], colors[3 * i + 1], colors[3 * i + 2]));
  }
  const Box2i all(Vec2i(0, 0), settings_.resolution - Vec2i(1, 1));
  try {
    view_.importance = ImportanceMap(whole ? all : settings_.crop, std::move(weights));
  } catch (const std::invalid_argument&) {
    throw UsageError("importance: " + text + " is black everywhere");
  }
}

void ChainIntegrator::end_pilot() {
  std::vector<float> luminances(pixels());
  for (const char* name : {"direct", "indirect"}) {
    const std::vector<float> colors =
        pilot_film_->develop(pilot_film_->layer(name), 1.0 / kPilotSamples);
    for (std::size_t i = 0; i < luminances.size(); ++i) {
      luminances[i] += luminance(Spectrum(colors[3 * i], colors[3 * i + 1], colors[3 * i + 2]));
    }
  }
  view_.importance = ImportanceMap::relative(settings_.crop, std::move(luminances));
  pilot_film_.reset();
  pilot_.reset();
}

std::uint64_t ChainIntegrator::begin_preparation(int round) {
  if (groups_.empty()) return 0;
  const auto index = static_cast<std::size_t>(round);
  if (index > 0) end(stages_[index - 1]);
  return index < stages_.size() ? begin(stages_[index]) : 0;
}

std::uint64_t ChainIntegrator::begin(Stage stage) {
  blocks_.clear();
  switch (stage) {
    case Stage::Pilot:
      pilot_film_ = std::make_unique<Film>(settings_.resolution, settings_.crop, Filter::box(), 1,
                                           pilot_->layers());
      return pilot_->items_in_pass();
    case Stage::Trial: {
      constexpr double kTrialShare = 0.1;  // on top of the bootstrap
      for (std::size_t g = 0; g < groups_.size(); ++g) {
        add_blocks(g, static_cast<std::uint64_t>(kTrialShare * static_cast<double>(bootstrap_) *
                                                 bootstrap_share(groups_[g])));
      }
      trial_light_.resize(blocks_.size());
      break;
    }
    case Stage::Bootstrap:
      begin_bootstrap();
      break;
  }
  return blocks_.size();
}

void ChainIntegrator::end(Stage stage) {
  switch (stage) {
    case Stage::Pilot:
      return end_pilot();
    case Stage::Trial:
      return end_trial();
    case Stage::Bootstrap:
      return end_bootstrap();
  }
}

void ChainIntegrator::prepare_item(int round, std::uint64_t item, Counters& counters) {
  switch (stages_[static_cast<std::size_t>(round)]) {
    case Stage::Pilot: {
      Counters own;
      pilot_->run_item(item, 0, kPilotSamples, *pilot_film_, own);
      counters.rays += own.rays;
      return;
    }
    case Stage::Trial:
      return run_trial(item, counters);
    case Stage::Bootstrap:
      return run_bootstrap(item, counters);
  }
}

void ChainIntegrator::add_blocks(std::size_t owner, std::uint64_t samples) {
  for (std::uint64_t first = 0; first < samples; first += kSamplesPerBlock) {
    blocks_.push_back({owner, first, std::min(samples, first + kSamplesPerBlock)});
  }
}

double ChainIntegrator::bootstrap_share(const PathGroup& group) const {
  const auto weight = [](const PathGroup& g) { return 1.0 / std::max(1, g.depth); };
  double whole = 0.0;
  for (const PathGroup& other : groups_) whole += weight(other);
  return weight(group) / whole;
}

void ChainIntegrator::run_trial(std::uint64_t item, Counters& counters) {
  const SampleBlock& block = blocks_[item];
  const PathGroup& group = groups_[block.owner];
  const std::uint64_t seed = hash_numbers(settings_.seed, 0x7e1a1ULL, group.depth);
  const auto target = make_target(group);
  std::vector<double>& light = trial_light_[item];
  light.assign(group.choice.size(), 0.0);
  SplatBuffer splats;
  for (std::uint64_t i = block.first; i < block.last; ++i) {
    BootstrapSource source(seed, i);
    splats.clear();
    const double scalar = target->evaluate(source, Change{}, splats);
    target->rejected();
    if (scalar > 0.0 && std::isfinite(scalar)) light[target->technique()->number] += scalar;
  }
  counters.rays += target->rays();
}

void ChainIntegrator::end_trial() {
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    std::vector<double> light(groups_[g].choice.size());
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      if (blocks_[i].owner != g) continue;
      for (std::size_t t = 0; t < light.size(); ++t) light[t] += trial_light_[i][t];
    }
    groups_[g].choice.adapt(light);
  }
  trial_light_.clear();
}

void ChainIntegrator::begin_bootstrap() {
  constexpr double kFewest = 64.0;
  const double per_replicate = static_cast<double>(bootstrap_) / settings_.replicates;
  for (int replicate = 0; replicate < settings_.replicates; ++replicate) {
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      ChainPopulation population{.group = g, .replicate = replicate};
      population.seed = hash_numbers(settings_.seed, 0xb0075ULL, replicate, groups_[g].depth);
      const double samples = std::max(kFewest, per_replicate * bootstrap_share(groups_[g]));
      population.weights.resize(static_cast<std::size_t>(samples));
      add_blocks(populations_.size(), population.weights.size());
      populations_.push_back(std::move(population));
    }
  }
}

void ChainIntegrator::run_bootstrap(std::uint64_t item, Counters& counters) {
  const SampleBlock& block = blocks_[item];
  ChainPopulation& population = populations_[block.owner];
  const auto target = make_target(groups_[population.group]);
  SplatBuffer splats;
  for (std::uint64_t i = block.first; i < block.last; ++i) {
    BootstrapSource source(population.seed, i);
    splats.clear();
    const double scalar = target->evaluate(source, Change{}, splats);
    target->rejected();
    // What is not a number is counted when a chain meets it; it can be no seed.
    population.weights[i] = scalar > 0.0 && std::isfinite(scalar) ? scalar : 0.0;
  }
  counters.rays += target->rays();
}

void ChainIntegrator::end_bootstrap() {
  chain_counts_.assign(static_cast<std::size_t>(settings_.replicates), 0);
  for (ChainPopulation& population : populations_) {
    population.bootstrap = bootstrap_moments(population.weights);
  }
  for (int replicate = 0; replicate < settings_.replicates; ++replicate) seed_replicate(replicate);
  for (std::size_t p = 0; p < populations_.size(); ++p) {
    ChainPopulation& population = populations_[p];
    population.weights = {};
    for (std::size_t c = 0; c < population.chains.size(); ++c) chain_items_.push_back({p, c});
    if (population.chains.empty()) chain_items_.push_back({p, 0});
  }
  add_concerns();
}

void ChainIntegrator::seed_replicate(int replicate) {
  std::vector<ChainPopulation*> own;
  std::vector<double> b;
  for (ChainPopulation& population : populations_) {
    if (population.replicate != replicate) continue;
    own.push_back(&population);
    b.push_back(population.bootstrap.mean());
  }
  // By default so many that a chain makes about a hundred steps in a short pass: many chains are
  // well spread, but each begins a pass by looking up its state.
  constexpr std::uint64_t kPixelsPerChain = 32;
  const std::uint64_t wanted = wanted_chains_ > 0 ? wanted_chains_ : pixels() / kPixelsPerChain;
  const auto replicates = static_cast<std::uint64_t>(settings_.replicates);
  const auto count = static_cast<std::size_t>(std::max<std::uint64_t>(1, wanted / replicates));
  const std::vector<std::size_t> shares = apportion(b, count);
  for (std::size_t i = 0; i < own.size(); ++i) {
    ChainPopulation& population = *own[i];
    const PathGroup& group = groups_[population.group];
    const double u =
        to_unit_float(static_cast<std::uint32_t>(hash_numbers(population.seed, 0x5eedULL) >> 32U));
    const std::size_t by_technique = kind_ == ChainKind::OnePath ? group.choice.size() : 0;
    for (const std::size_t index : choose_seeds(population.weights, shares[i], u)) {
      const std::uint64_t chain_seed =
          hash_numbers(population.seed, 0xc4a15ULL, population.chains.size());
      population.chains.push_back(
          {Chain(group.shape, chain_seed, bootstrap_key(population.seed, index),
                 population.weights[index]),
           {},
           std::vector<ChainStatistics::Kind>(by_technique)});
    }
    chain_counts_[static_cast<std::size_t>(replicate)] += population.chains.size();
  }
}

void ChainIntegrator::add_concerns() {
  std::uint64_t lit = 0;
  std::uint64_t samples = 0;
  for (const ChainPopulation& population : populations_) {
    samples += population.bootstrap.count;
    lit += population.chains.size();
  }
  if (lit > 0 || populations_.empty()) return;
  concerns_.push_back("none of " + std::to_string(samples) +
                      " bootstrap paths carries light, so there is nothing to start Markov chains "
                      "from: indirect light is sampled without them and may stay black; try a "
                      "larger bootstrap (--set bootstrap=10000000), a larger --depth, or see "
                      "whether the scene has lights that reach what the camera sees");
}

std::unique_ptr<PathTarget> ChainIntegrator::make_target(const PathGroup& group) const {
  if (kind_ == ChainKind::WholePath) {
    return std::make_unique<WholePathTarget>(scene_, group.sampler, view_);
  }
  return std::make_unique<OnePathTarget>(scene_, group.sampler, group.choice, view_);
}

std::vector<LayerSpec> ChainIntegrator::layers() const {
  double b = 0.0;
  for (const ChainPopulation& population : populations_) b += population.bootstrap.mean();
  b /= settings_.replicates;
  const double magnitude = b > 0.0 && std::isfinite(b) ? b : 1.0;
  std::vector<LayerSpec> specs;
  if (direct_light_) {
    specs = direct_light_->layers();
    for (LayerSpec& spec : specs) {
      if (spec.name == "indirect") spec.magnitude = magnitude;
    }
  } else {
    specs = {{.name = "direct", .magnitude = magnitude},
             {.name = "indirect", .magnitude = magnitude}};
  }
  for (const std::string& name : {kDensity, kAcceptance}) {
    if (asks_for(settings_.aovs, name)) specs.push_back({.name = name, .has_replicates = false});
  }
  return specs;
}

std::uint64_t ChainIntegrator::items_in_pass() const {
  return (direct_light_ ? direct_light_->items_in_pass() : 0) + chain_items_.size();
}

std::uint64_t ChainIntegrator::direct_samples(std::uint64_t mutations) const {
  const auto replicates = static_cast<std::uint64_t>(settings_.replicates);
  const double per_replicate =
      static_cast<double>(mutations) * direct_share_ / static_cast<double>(replicates);
  return replicates * static_cast<std::uint64_t>(std::ceil(per_replicate));
}

std::uint64_t ChainIntegrator::steps_until(std::uint64_t samples, std::size_t chains) const {
  const double per_replicate = static_cast<double>(samples) * static_cast<double>(pixels()) /
                               static_cast<double>(settings_.replicates);
  return static_cast<std::uint64_t>(std::ceil(per_replicate / static_cast<double>(chains)));
}

/// b of a population is on average right only over all that its bootstrap can bring, finding no
/// light included. So where it found none, later samples may count neither more nor less than they
/// do where it found some: they have one weight w for all, which must not depend on what was found.
/// E[(1 − w)·bootstrap; light found] + w·E[later samples] is then b.
void ChainIntegrator::begin_pass(std::uint64_t first_sample, std::uint64_t /*samples*/) {
  first_sample_ = first_sample;
  double bootstrap = 0.0;
  for (const ChainPopulation& population : populations_) {
    bootstrap += static_cast<double>(population.bootstrap.count);
  }
  const double large_steps = chain_settings_.probabilities.large *
                             static_cast<double>(first_sample) * static_cast<double>(pixels());
  later_weight_ = large_steps / (bootstrap + large_steps);
  b_.clear();
  for (const ChainPopulation& population : populations_) {
    const Moments later = population.later_moments();
    const double weight = later.count > 0 ? later_weight_ : 0.0;
    b_.push_back((1.0 - weight) * population.bootstrap.mean() + weight * later.mean());
  }
}

void ChainIntegrator::run_item(std::uint64_t item, std::uint64_t first_sample,
                               std::uint64_t samples, Film& film, Counters& counters) {
  const std::uint64_t tiles = direct_light_ ? direct_light_->items_in_pass() : 0;
  if (item < tiles) {
    const std::uint64_t first = direct_samples(first_sample);
    const std::uint64_t last = direct_samples(first_sample + samples);
    if (first < last) direct_light_->run_item(item, first, last - first, film, counters);
    return;
  }
  const ChainItem& chain = chain_items_[item - tiles];
  ChainPopulation& population = populations_[chain.population];
  if (population.chains.empty()) {
    run_plain(population, samples, film, counters);
  } else {
    run_chain(chain, samples, film, counters);
  }
}

void ChainIntegrator::run_chain(const ChainItem& item, std::uint64_t samples, Film& film,
                                Counters& counters) {
  ChainPopulation& population = populations_[item.population];
  MemberChain& member = population.chains[item.chain];
  const PathGroup& group = groups_[population.group];
  const std::size_t chains = chains_in(population.replicate);
  const std::uint64_t steps = std::max<std::uint64_t>(
      1, steps_until(first_sample_ + samples, chains) - steps_until(first_sample_, chains));
  const auto target = make_target(group);
  ChainRunner runner(chain_settings_, *mutation_, group.shape, *target);
  FilmSink sink(film, population.replicate, view_.importance, *target, counters);
  const double b = b_[item.population];
  const double per_step =
      1.0 / (static_cast<double>(steps) * static_cast<double>(population.chains.size()));
  sink.begin(b * view_.area() * per_step * static_cast<double>(samples) / settings_.replicates,
             member.by_technique.empty() ? nullptr : &member.by_technique);
  const ChainStatistics statistics =
      runner.run(member.chain, steps, sink, mis_large_steps_ ? std::optional(b) : std::nullopt);
  member.statistics += statistics;
  counters.mutations += steps;
  counters.rays += target->rays();
  counters.discarded_nan += statistics.discarded_nan;
  counters.discarded_infinite += statistics.discarded_infinite;
  counters.discarded_negative += statistics.discarded_negative;
  if (statistics.first_discarded && counters.first_discarded.empty()) {
    const auto& place = *statistics.first_discarded;
    counters.first_discarded = "proposal of the chain with seed " + std::to_string(place.seed) +
                               ", origin " + std::to_string(place.origin) + ", after " +
                               std::to_string(place.step) + " steps";
  }
}

/// A population whose bootstrap found no light has no chain to run. Its paths are sampled
/// independently instead. They stand for the large steps that its chains would have made, and have
/// their weight: see `begin_pass`.
void ChainIntegrator::run_plain(ChainPopulation& population, std::uint64_t samples, Film& film,
                                Counters& counters) {
  if (later_weight_ == 0.0) return;
  constexpr double kShare = 0.125;  // of the replicate's mutations, if it has chains
  std::size_t seedless = 0;
  for (const ChainPopulation& other : populations_) {
    if (other.replicate == population.replicate && other.chains.empty()) ++seedless;
  }
  const double mutations = static_cast<double>(samples) * static_cast<double>(pixels()) /
                           settings_.replicates / static_cast<double>(seedless);
  const double share = chains_in(population.replicate) > 0 ? kShare : 1.0;
  const auto count = static_cast<std::uint64_t>(std::max(1.0, share * mutations));
  const auto target = make_target(groups_[population.group]);
  FilmSink sink(film, population.replicate, view_.importance, *target, counters);
  const double scale = later_weight_ * view_.area() / static_cast<double>(count) *
                       static_cast<double>(samples) / settings_.replicates;
  SplatBuffer splats;
  const std::uint64_t seed = hash_numbers(population.seed, 0x91a17ULL);
  for (std::uint64_t i = 0; i < count; ++i) {
    BootstrapSource source(seed, population.plain_samples++);
    splats.clear();
    const double scalar = target->evaluate(source, Change{}, splats);
    target->rejected();
    population.plain_statistics.large_steps.add(std::isfinite(scalar) ? std::max(0.0, scalar)
                                                                      : 0.0);
    if (std::isnan(scalar)) {
      ++counters.discarded_nan;
    } else if (std::isinf(scalar)) {
      ++counters.discarded_infinite;
    } else if (scalar < 0.0) {
      ++counters.discarded_negative;
    } else if (scalar > 0.0) {
      // Over I, as chains deposit their states: one visit for the density.
      sink.begin(scale * scalar, nullptr);
      sink.deposit(splats, 1.0 / scalar);
    }
  }
  counters.mutations += count;
  counters.rays += target->rays();
}

double ChainIntegrator::develop_scale(const LayerSpec& layer, std::uint64_t samples,
                                      std::optional<int> replicate) const {
  const bool of_chains = layer.name == "indirect" || layer.name == kDensity ||
                         layer.name == kAcceptance || !direct_light_;
  if (!of_chains) return direct_light_->develop_scale(layer, direct_samples(samples), replicate);
  if (samples == 0) return 0.0;
  const double scale = 1.0 / static_cast<double>(samples);
  return replicate ? scale * settings_.replicates : scale;
}

std::optional<ChainReport> ChainIntegrator::chain_report() const {
  ChainReport report;
  ChainStatistics whole;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    ChainReport::Depth depth{groups_[g].depth, 0, 0, 0.0, 0.0, 0.0};
    ChainStatistics own;
    double variance = 0.0;
    const TechniqueChoice& choice = groups_[g].choice;
    std::vector<ChainStatistics::Kind> by_technique(choice.size());
    for (const ChainPopulation& population : populations_) {
      if (population.group != g) continue;
      report.bootstrap_samples += population.bootstrap.count;
      const Moments moments = population.moments();
      depth.b += moments.mean() / settings_.replicates;
      variance += moments.standard_error() * moments.standard_error();
      depth.chains += population.chains.size();
      depth.mutations += population.plain_samples;
      for (const MemberChain& member : population.chains) {
        own += member.statistics;
        for (std::size_t s = 0; s < member.by_technique.size(); ++s) {
          by_technique[s].proposals += member.by_technique[s].proposals;
          by_technique[s].acceptances += member.by_technique[s].acceptances;
        }
      }
    }
    depth.b_standard_error = std::sqrt(variance) / settings_.replicates;
    depth.mutations += own.steps;
    double accepted = 0.0;
    for (const ChainStatistics::Kind& kind : own.kinds) accepted += kind.acceptances;
    if (own.steps > 0) depth.acceptance = accepted / static_cast<double>(own.steps);
    for (std::size_t s = 0; s < by_technique.size(); ++s) {
      const ChainStatistics::Kind& kind = by_technique[s];
      if (kind.proposals == 0) continue;
      report.techniques.push_back(
          {choice[s], kind.proposals, kind.acceptances / static_cast<double>(kind.proposals)});
    }
    report.depths.push_back(depth);
    whole += own;
  }
  const auto mean = [](std::initializer_list<ChainStatistics::Kind> kinds) {
    ChainStatistics::Kind sum;
    for (const ChainStatistics::Kind& kind : kinds) {
      sum.proposals += kind.proposals;
      sum.acceptances += kind.acceptances;
    }
    return sum.proposals > 0 ? sum.acceptances / static_cast<double>(sum.proposals) : 0.0;
  };
  report.large_acceptance = mean({whole.of(StepKind::Large)});
  report.small_acceptance = mean({whole.of(StepKind::SmallBoth), whole.of(StepKind::SmallCamera),
                                  whole.of(StepKind::SmallLight)});
  report.longest_rejection_streak = whole.longest_streak;
  return report;
}

}  // namespace

std::unique_ptr<Integrator> make_chain_integrator(ChainKind kind, const Scene& scene,
                                                  const RenderSettings& settings,
                                                  const Parameters& parameters) {
  return std::make_unique<ChainIntegrator>(kind, scene, settings, parameters);
}

}  // namespace ajar
