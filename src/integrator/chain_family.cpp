#include "integrator/chain_family.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/milestones.h"
#include "core/random.h"
#include "integrator/chain_archive.h"
#include "integrator/chain_bootstrap.h"
#include "integrator/chain_effort.h"
#include "integrator/chain_film_sink.h"
#include "integrator/chain_pilot.h"
#include "integrator/chain_plan.h"
#include "integrator/chain_recruits.h"
#include "integrator/chain_report.h"
#include "integrator/chain_stretch.h"
#include "integrator/chain_trial.h"
#include "integrator/omc_adaptation.h"
#include "integrator/path_family.h"
#include "integrator/plane_maps.h"
#include "integrator/roulette_pilot.h"
#include "integrator/split_pilot.h"
#include "integrator/technique_pilot.h"
#include "integrator/weighted_errors.h"
#include "mcmc/bootstrap_source.h"
#include "mcmc/chain_runner.h"

namespace ajar {

namespace {

bool asks_for(const std::vector<std::string>& aovs, const std::string& name) {
  return std::find(aovs.begin(), aovs.end(), name) != aovs.end();
}

class ChainIntegrator final : public Integrator {
 public:
  ChainIntegrator(ChainKind kind, const Scene& scene, const RenderSettings& settings,
                  const Parameters& parameters, std::optional<SelectiveSettings> selective);

  PreparationRound begin_preparation(int round) override;
  void prepare_item(int round, std::uint64_t item, Counters& counters) override;
  void skip_preparation() override;
  std::vector<std::string> concerns() const override;
  std::vector<std::string> notes() const override { return notes_on(plan_, recruits_ != nullptr); }

  std::vector<LayerSpec> layers() const override;
  std::uint64_t items_in_pass() const override;
  void begin_pass(std::uint64_t first_sample, std::uint64_t samples, Film& film) override;
  void run_item(std::uint64_t item, std::uint64_t first_sample, std::uint64_t samples, Film& film,
                Counters& counters) override;
  double develop_scale(const LayerSpec& layer, std::uint64_t samples,
                       std::optional<int> replicate) const override;
  std::optional<ChainReport> chain_report() const override;
  std::optional<SelectiveReport> selective_report() const override;

  bool keeps_state() const override { return !populations_.empty() || learns(); }
  void save_state(OutputArchive& archive) const override;
  void load_state(InputArchive& archive) override;
  void give_news(OutputArchive& archive, const WorkShare& share) override;
  void take_news(InputArchive& archive, const WorkShare& share) override;
  std::uint64_t memory_bytes() const override;
  std::vector<std::pair<std::string, Plane>> maps() const override {
    return plan_.selective && pilot_ != nullptr ? pilot_->maps() : Integrator::maps();
  }
  std::optional<Plane> antialias_mask() const override {
    return plan_.selective && pilot_ != nullptr ? pilot_->antialias_mask() : std::nullopt;
  }

 private:
  /// A chain, or the plain samples of a population without seeds.
  struct ChainItem {
    std::size_t population;
    std::size_t chain;
  };

  void end_preparation();
  void list_chains();
  /// Writes or reads what the items of a share have left behind in their own chains.
  template <Archive A>
  void serialize_items(A& archive, const WorkShare& share);
  void make_omc();
  /// Whether ordinary Monte Carlo does, as the render goes on.
  bool learns() const { return adaptation_ && adaptation_->learns(); }
  /// By the errors that replicates show after `samples` samples: how much effort which half
  /// deserves, and where.
  void share_effort(std::uint64_t samples, const Film& film);
  /// Lets what ordinary Monte Carlo has found in the stretch that ends join the chains.
  void join_recruits(const Film& film);
  /// Begins the next stretch.
  void expect_recruits();
  void run_chain(const ChainItem& item, std::uint64_t first_sample, std::uint64_t samples,
                 Film& film, Counters& counters);
  /// One mutation per pixel's worth.
  void run_plain(ChainPopulation& population, Film& film, Counters& counters);
  void refine_b(std::uint64_t samples);
  /// b as the bootstrap has it, over all replicates; 1 if it found no light.
  double bootstrap_b() const;
  const PlaneMoves* plane_moves(const ChainPopulation& population) const {
    return maps_ ? maps_->moves(population.replicate) : nullptr;
  }
  /// What of a chain's deposits the picture takes, if that is not all.
  const LightSplit* kept_by(int replicate) const {
    return plan_.selective && plan_.selective->exclusive && plan_.splits
               ? &plan_.splits->of(replicate)
               : nullptr;
  }
  std::size_t chains_in(int replicate) const {
    return chain_counts_[static_cast<std::size_t>(replicate)];
  }

  ChainPlan plan_;
  ChainEffort effort_{plan_};
  std::vector<std::unique_ptr<PreparationStage>> stages_;
  SplitPilot* pilot_ = nullptr;  ///< one of the stages; null if there is nothing to decide
  std::size_t stage_ = 0;        ///< that is running
  std::vector<ChainPopulation> populations_;
  std::vector<std::size_t> chain_counts_;  ///< per replicate
  std::vector<ChainItem> chain_items_;
  std::unique_ptr<OmcAdaptation> adaptation_;  ///< null if the next is
  std::unique_ptr<Integrator> omc_;            ///< null if it has nothing to render
  std::vector<std::string> concerns_;
  std::unique_ptr<PlaneMaps> maps_;  ///< null if steps do not follow the image plane
  std::vector<double> b_;            ///< of each population
  double later_weight_ = 0.0;        ///< of samples after the bootstrap, in all estimates of b
  std::uint64_t doubled_at_ = 0;     ///< samples per pixel
  std::unique_ptr<ChainRecruits> recruits_;  ///< null unless ordinary Monte Carlo finds seeds
  ChainStretch stretch_;
};

ChainIntegrator::ChainIntegrator(ChainKind kind, const Scene& scene, const RenderSettings& settings,
                                 const Parameters& parameters,
                                 std::optional<SelectiveSettings> selective)
    : plan_(kind, scene, settings, parameters, std::move(selective)),
      chain_counts_(static_cast<std::size_t>(settings.replicates), 0) {
  if (plan_.groups.empty()) {
    make_omc();
    return;
  }
  stages_.push_back(std::make_unique<ChainPilot>(plan_));
  if (plan_.has_recruits()) recruits_ = std::make_unique<ChainRecruits>(plan_);
  if (plan_.selective || recruits_) {
    for (auto& stage : TechniquePilot::make_all(plan_)) stages_.push_back(std::move(stage));
    if (plan_.selective && plan_.selective->efficient_roulette) {
      stages_.push_back(std::make_unique<RoulettePilot>(plan_));
    }
    auto pilot = std::make_unique<SplitPilot>(plan_, populations_, recruits_.get());
    auto trial = std::make_unique<ChainTrial>(plan_, *pilot, recruits_.get());
    pilot_ = pilot.get();
    stages_.push_back(std::move(pilot));
    stages_.push_back(std::move(trial));
  }
  stages_.push_back(std::make_unique<ChainBootstrap>(plan_, populations_));
}

PreparationRound ChainIntegrator::begin_preparation(int round) {
  if (stages_.empty()) return {};
  if (round > 0) stages_[stage_++]->end();
  for (; stage_ < stages_.size(); stages_[stage_++]->end()) {
    PreparationStage& stage = *stages_[stage_];
    const std::uint64_t items = stage.begin();
    if (items == 0) continue;
    PreparationRound next{items, stage.effort(), 0.0};
    for (std::size_t i = stage_ + 1; i < stages_.size(); ++i) {
      next.later_effort += stages_[i]->effort();
    }
    return next;
  }
  end_preparation();
  return {};
}

void ChainIntegrator::prepare_item(int /*round*/, std::uint64_t item, Counters& counters) {
  stages_[stage_]->run(item, counters);
}

void ChainIntegrator::skip_preparation() {
  if (stages_.empty()) return;
  stages_.clear();
  pilot_ = nullptr;
  recruits_.reset();
  populations_.clear();
  plan_.leave_to_omc();
  make_omc();
}

void ChainIntegrator::list_chains() {
  chain_items_.clear();
  std::fill(chain_counts_.begin(), chain_counts_.end(), 0);
  for (std::size_t p = 0; p < populations_.size(); ++p) {
    const ChainPopulation& population = populations_[p];
    chain_counts_[static_cast<std::size_t>(population.replicate)] += population.chain_count();
    for (std::size_t c = 0; c < population.chains.size(); ++c) chain_items_.push_back({p, c});
    if (population.chains.empty() && !recruits_) chain_items_.push_back({p, 0});
  }
}

void ChainIntegrator::end_preparation() {
  // With a black pilot there is nothing to divide by.
  if (!plan_.splits || plan_.mutations == 0.0) recruits_.reset();
  if (plan_.mutations == 0.0) populations_.clear();
  make_omc();
  list_chains();
  if (recruits_) expect_recruits();
  concerns_ = concerns_about(plan_, populations_);
  if (plan_.plane.active()) {
    maps_ = std::make_unique<PlaneMaps>(plan_.plane, plan_.view, plan_.settings.replicates,
                                        bootstrap_b(), *plan_.mutation);
  }
}

std::vector<std::string> ChainIntegrator::concerns() const {
  std::vector<std::string> all = concerns_;
  if (omc_) {
    for (std::string& concern : omc_->concerns()) all.push_back(std::move(concern));
  }
  return all;
}

void ChainIntegrator::make_omc() {
  const std::pair<int, int> depths = plan_.omc_depths();
  if (depths.first > depths.second) return;
  const RenderSettings settings = plan_.omc_settings();
  adaptation_ = std::make_unique<OmcAdaptation>(plan_, settings);
  PathIntegratorContext context{.splits = plan_.splits ? &*plan_.splits : nullptr,
                                .strong = recruits_.get()};
  adaptation_->tell(context);
  omc_ = plan_.make_omc(settings, depths, context);
}

std::optional<ChainReport> ChainIntegrator::chain_report() const {
  ChainReport report = report_chains(plan_, populations_, later_weight_);
  if (pilot_ != nullptr && !plan_.selective) report.split = pilot_->thresholds();
  return report;
}

std::optional<SelectiveReport> ChainIntegrator::selective_report() const {
  if (!plan_.selective || pilot_ == nullptr) return std::nullopt;
  SelectiveReport report;
  report.pilot_samples = pilot_->samples();
  report.pilot_stays = plan_.pilot_kept > 0;
  report.techniques = plan_.omc.techniques;
  report.light_paths_per_sample = std::stod(plan_.omc.light_paths_per_pixel);
  if (adaptation_ && adaptation_->price()) {
    report.ray_price = adaptation_->price()->price() / plan_.brightness;
    report.path_rest = adaptation_->price()->rest() / plan_.brightness;
  }
  report.regions = pilot_->report();
  effort_.fill(report);
  return report;
}

double ChainIntegrator::bootstrap_b() const {
  double b = 0.0;
  for (const ChainPopulation& population : populations_) b += population.b(0.0);
  b /= plan_.settings.replicates;
  return b > 0.0 && std::isfinite(b) ? b : 1.0;
}

std::vector<LayerSpec> ChainIntegrator::layers() const {
  const double magnitude = bootstrap_b();
  std::vector<LayerSpec> specs;
  if (omc_) {
    specs = omc_->layers();
    for (LayerSpec& spec : specs) {
      if (spec.name == "indirect") spec.magnitude = magnitude;
    }
  } else {
    specs = {{.name = "direct", .magnitude = magnitude},
             {.name = "indirect", .magnitude = magnitude}};
  }
  for (const std::string& name : {kDensityLayer, kAcceptanceLayer}) {
    if (asks_for(plan_.settings.aovs, name))
      specs.push_back({.name = name, .has_replicates = false});
  }
  return specs;
}

std::uint64_t ChainIntegrator::items_in_pass() const {
  return (omc_ ? omc_->items_in_pass() : 0) + chain_items_.size();
}

/// b is refined, recruits join, and the maps of the image plane end an epoch, at counts fixed in
/// advance, which passes do not cross (see `PassSchedule`): where passes end otherwise is up to the
/// clock, and must not change the picture.
void ChainIntegrator::begin_pass(std::uint64_t first_sample, std::uint64_t samples, Film& film) {
  if (first_sample == 0) {
    refine_b(0);
    for (const auto& stage : stages_) stage->hand_over(film);
  }
  if (recruits_ && first_sample >= stretch_.end()) join_recruits(film);
  if (recruits_ && first_sample + samples > stretch_.end()) {
    throw std::logic_error("bug: a pass crosses a milestone");
  }
  auto milestone = static_cast<std::uint64_t>(plan_.settings.replicates);
  if (first_sample < milestone) return;
  while (2 * milestone <= first_sample) milestone *= 2;
  if (milestone <= doubled_at_) return;
  doubled_at_ = milestone;
  if (!recruits_) {
    share_effort(first_sample, film);
    refine_b(milestone);
  }
  if (maps_) maps_->end_epoch(effort_.mutations(milestone));
}

void ChainIntegrator::join_recruits(const Film& film) {
  recruits_->join(populations_, effort_.omc_samples(stretch_.begin()),
                  effort_.omc_samples(stretch_.end()));
  list_chains();
  refine_b(stretch_.end());
  share_effort(stretch_.end(), film);
  expect_recruits();
}

void ChainIntegrator::share_effort(std::uint64_t samples, const Film& film) {
  const bool shares = effort_.can_adjust();
  if (film.replicates() < 2 || !(shares || learns())) return;
  const auto pictures = [&](std::initializer_list<std::string> names) {
    return develop_layers(film, *this, samples, names);
  };
  const auto guesses = [&](const std::string& name) {
    return film.layer(name) < 0 ? std::vector<float>() : replicate_median(pictures({name}));
  };
  const Box2i& crop = plan_.settings.crop;
  const ImportanceMap& importance = plan_.view.importance;
  const Replicates by_omc = pictures({"direct", kWeakLayer});
  const WeightedErrors of_omc = weighted_errors(by_omc, crop, importance);
  if (learns()) {
    SampleRates::Guesses needed;
    if (adaptation_->needs_guesses()) needed = {guesses("direct"), guesses(kWeakLayer)};
    adaptation_->adjust(of_omc.variance, std::move(needed), effort_.omc_samples(samples),
                        effort_.rays_per_camera_sample());
  }
  if (!shares) return;
  const Replicates by_chains = pictures({"indirect"});
  std::optional<ChainEffort::Seen> seen;
  if (plan_.selective) {
    seen = {seen_light(by_omc, crop, importance), seen_light(by_chains, crop, importance),
            stretch_.weight_until(samples), stretch_.sample_weight()};
  }
  effort_.adjust(samples, of_omc, weighted_errors(by_chains, crop, importance), seen);
}

void ChainIntegrator::expect_recruits() {
  stretch_.go_on(
      milestone_after(stretch_.end(), static_cast<std::uint64_t>(plan_.settings.replicates)),
      populations_.front().samples_behind / static_cast<double>(plan_.pixels()));
  recruits_->expect(populations_, static_cast<double>(effort_.omc_samples(stretch_.end()) -
                                                      effort_.omc_samples(stretch_.begin())));
}

/// b of a population is on average right only over all that its bootstrap can bring, finding no
/// light included. So where it found none, later samples may count neither more nor less than they
/// do where it found some: they have one weight w for all, which must not depend on what was found.
/// E[(1 − w)·bootstrap; light found] + w·E[later samples] is then b. Of I beyond the cap only the
/// bootstrap knows (see `ChainPopulation::b`), so later samples bring no more than it.
void ChainIntegrator::refine_b(std::uint64_t samples) {
  if (populations_.empty()) return;
  double bootstrap = 0.0;
  for (const ChainPopulation& population : populations_) {
    bootstrap += static_cast<double>(population.capped.count);
  }
  const double large_steps = plan_.chain_settings.probabilities.large * plan_.chain_settings.tries *
                             effort_.mutations(samples) * static_cast<double>(plan_.pixels());
  later_weight_ = large_steps / (bootstrap + large_steps);
  b_.clear();
  for (const ChainPopulation& population : populations_) {
    b_.push_back(population.b(later_weight_));
  }
}

void ChainIntegrator::run_item(std::uint64_t item, std::uint64_t first_sample,
                               std::uint64_t samples, Film& film, Counters& counters) {
  const std::uint64_t tiles = omc_ ? omc_->items_in_pass() : 0;
  if (item < tiles) {
    const std::uint64_t first = effort_.omc_samples(first_sample);
    const std::uint64_t last = effort_.omc_samples(first_sample + samples);
    if (first == last) return;
    omc_->run_item(item, first, last - first, film, counters);
    effort_.count_omc(counters.rays, counters.samples);
    return;
  }
  const ChainItem& chain = chain_items_[item - tiles];
  ChainPopulation& population = populations_[chain.population];
  if (population.chains.empty()) {
    for (std::uint64_t i = 0; i < samples; ++i) run_plain(population, film, counters);
    effort_.count_chains(counters.rays, counters.mutations);
  } else {
    run_chain(chain, first_sample, samples, film, counters);
  }
}

/// Steps are made in blocks of one mutation per pixel, each deposited by itself, so that the film's
/// bits do not depend on how many blocks a pass has.
void ChainIntegrator::run_chain(const ChainItem& item, std::uint64_t first_sample,
                                std::uint64_t samples, Film& film, Counters& counters) {
  ChainPopulation& population = populations_[item.population];
  MemberChain& member = population.chains[item.chain];
  const PathGroup& group = plan_.groups[population.group];
  const std::size_t chains = chains_in(population.replicate);
  const auto target = plan_.make_target(group, population.replicate);
  ChainRunner runner(plan_.chain_settings_of(population.replicate), *plan_.mutation, group.shape,
                     *target, plane_moves(population));
  ChainFilmSink sink(film, population.replicate, plan_.view.importance, *target, counters,
                     maps_.get(), kept_by(population.replicate));
  const double b = b_[item.population];
  const auto in_population = static_cast<double>(population.chain_count());
  runner.start(member.chain);
  // How often chains are started is up to the clock, which must not share the effort.
  const std::uint64_t rays_to_start = target->rays();
  ChainStatistics statistics;
  for (std::uint64_t block = first_sample; block < first_sample + samples; ++block) {
    const std::uint64_t steps = effort_.steps(block, chains);
    const double per_step = 1.0 / (static_cast<double>(steps) * in_population);
    sink.begin(stretch_.sample_weight() * member.weight * b * plan_.view.area() * per_step /
                   plan_.settings.replicates,
               member.record.by_technique.empty() ? nullptr : &member.record.by_technique);
    statistics += runner.go_on(member.chain, steps * member.multiplicity, sink,
                               plan_.mis_large_steps ? std::optional(b) : std::nullopt);
  }
  effort_.count_chains(target->rays() - rays_to_start, statistics.steps);
  member.record.statistics += statistics;
  counters.mutations += statistics.steps;
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
/// their weight: see `begin_pass`. What one of them carries is spread over a short chain that
/// starts from it (Cline et al. 2005), since light so hard to find would be a firefly: the chain
/// leaves the distribution of its start as it is, so each of its states stands for the sample as
/// well.
void ChainIntegrator::run_plain(ChainPopulation& population, Film& film, Counters& counters) {
  if (later_weight_ == 0.0) return;
  constexpr double kShare = 0.125;  // of the replicate's mutations, if it has chains
  constexpr std::uint64_t kSteps = 64;
  std::size_t seedless = 0;
  for (const ChainPopulation& other : populations_) {
    if (other.replicate == population.replicate && other.chains.empty()) ++seedless;
  }
  const double mutations = plan_.mutations * static_cast<double>(plan_.pixels()) /
                           plan_.settings.replicates / static_cast<double>(seedless);
  const double share = chains_in(population.replicate) > 0 ? kShare : 1.0;
  const auto count = static_cast<std::uint64_t>(std::max(1.0, share * mutations));
  const PathGroup& group = plan_.groups[population.group];
  const auto target = plan_.make_target(group, population.replicate);
  ChainRunner runner(plan_.chain_settings_of(population.replicate), *plan_.mutation, group.shape,
                     *target, plane_moves(population));
  ChainFilmSink sink(film, population.replicate, plan_.view.importance, *target, counters,
                     maps_.get(), kept_by(population.replicate));
  const double scale =
      later_weight_ * plan_.view.area() / static_cast<double>(count) / plan_.settings.replicates;
  SplatBuffer splats;
  const std::uint64_t seed = hash_numbers(population.seed, 0x91a17ULL);
  counters.mutations += count;
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t index = population.plain_samples++;
    BootstrapSource source(seed, index);
    splats.clear();
    const double scalar = target->evaluate(source, Change{}, splats);
    target->rejected();
    const double capped = std::min(scalar, plan_.chain_settings.large_step_cap);
    population.plain_statistics.large_steps.add(std::isfinite(scalar) ? std::max(0.0, capped)
                                                                      : 0.0);
    if (std::isnan(scalar)) {
      ++counters.discarded_nan;
    } else if (std::isinf(scalar)) {
      ++counters.discarded_infinite;
    } else if (scalar < 0.0) {
      ++counters.discarded_negative;
    } else if (scalar > 0.0) {
      Chain chain(group.shape, hash_numbers(seed, 0xc4a15ULL, index), bootstrap_key(seed, index),
                  scalar);
      sink.begin(scale * capped / static_cast<double>(kSteps), nullptr);
      runner.run(chain, kSteps, sink);
      counters.mutations += kSteps;
    }
  }
  counters.rays += target->rays();
}

void ChainIntegrator::save_state(OutputArchive& archive) const {
  archive(static_cast<std::uint64_t>(populations_.size()), b_, later_weight_, doubled_at_,
          stretch_);
  for (const ChainPopulation& population : populations_) {
    serialize_population(archive, population, plan_.groups[population.group].shape);
  }
  effort_.save_state(archive);
  if (adaptation_) adaptation_->save_state(archive);
  if (recruits_) recruits_->save_state(archive);
  if (maps_) maps_->save_state(archive);
}

void ChainIntegrator::load_state(InputArchive& archive) {
  std::uint64_t populations = 0;
  archive(populations, b_, later_weight_, doubled_at_, stretch_);
  if (populations != populations_.size() || (!b_.empty() && b_.size() != populations)) {
    throw std::runtime_error("other chains are prepared than there were");
  }
  for (ChainPopulation& population : populations_) {
    const PathGroup& group = plan_.groups[population.group];
    serialize_population(archive, population, group.shape);
    for (const MemberChain& member : population.chains) {
      const std::size_t counted = member.record.by_technique.size();
      if ((counted > 0 && counted != group.choice.size()) || member.multiplicity == 0) {
        throw std::runtime_error("a chain does not fit its population");
      }
    }
  }
  effort_.load_state(archive);
  if (adaptation_) adaptation_->load_state(archive);
  if (recruits_) recruits_->load_state(archive);
  if (maps_) maps_->load_state(archive);
  list_chains();
}

template <Archive A>
void ChainIntegrator::serialize_items(A& archive, const WorkShare& share) {
  const std::uint64_t tiles = omc_ ? omc_->items_in_pass() : 0;
  for (std::size_t i = 0; i < chain_items_.size(); ++i) {
    if (!share.has(tiles + i)) continue;
    ChainPopulation& population = populations_[chain_items_[i].population];
    if (population.chains.empty()) {
      serialize_plain(archive, population);
    } else {
      archive(population.chains[chain_items_[i].chain]);
    }
  }
}

void ChainIntegrator::give_news(OutputArchive& archive, const WorkShare& share) {
  serialize_items(archive, share);
  effort_.give_news(archive);
  if (recruits_) recruits_->give_news(archive);
  if (maps_) maps_->give_news(archive);
}

void ChainIntegrator::take_news(InputArchive& archive, const WorkShare& share) {
  serialize_items(archive, share);
  effort_.take_news(archive);
  if (recruits_) recruits_->take_news(archive);
  if (maps_) maps_->take_news(archive);
}

std::uint64_t ChainIntegrator::memory_bytes() const {
  std::uint64_t bytes = effort_.memory_bytes() + (maps_ ? maps_->memory_bytes() : 0);
  if (adaptation_) bytes += adaptation_->memory_bytes();
  for (const ChainPopulation& population : populations_) {
    for (const MemberChain& member : population.chains) {
      // Of recruits there are a few per chain, which are as large.
      bytes += (recruits_ ? 1 + ChainRecruits::kPerChain : 1) * member.chain.memory_bytes();
      bytes += sizeof(MemberChain) - sizeof(Chain);
    }
  }
  return bytes;
}

double ChainIntegrator::develop_scale(const LayerSpec& layer, std::uint64_t samples,
                                      std::optional<int> replicate) const {
  if (layer.name == kDensityLayer) {
    const double mutations = effort_.mutations(samples);
    return mutations > 0.0 ? 1.0 / mutations : 0.0;
  }
  if (layer.name == kAcceptanceLayer) return samples > 0 ? 1.0 / static_cast<double>(samples) : 0.0;
  const bool of_chains = layer.name == "indirect" ||
                         (layer.name == "direct" && plan_.direct == ChainPlan::Direct::Chain) ||
                         !omc_;
  if (!of_chains || plan_.unprepared) {
    return omc_->develop_scale(layer, effort_.omc_samples(samples), replicate);
  }
  if (samples == 0) return 0.0;
  const double scale = 1.0 / stretch_.weight_until(samples);
  return replicate ? scale * plan_.settings.replicates : scale;
}

}  // namespace

std::unique_ptr<Integrator> make_chain_integrator(ChainKind kind, const Scene& scene,
                                                  const RenderSettings& settings,
                                                  const Parameters& parameters,
                                                  std::optional<SelectiveSettings> selective) {
  return std::make_unique<ChainIntegrator>(kind, scene, settings, parameters, std::move(selective));
}

}  // namespace ajar
