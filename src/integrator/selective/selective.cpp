#include "integrator/selective/selective.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/milestones.h"
#include "image/statistics.h"
#include "integrator/metropolis/chain_film_sink.h"
#include "integrator/metropolis/path_seeds.h"
#include "integrator/montecarlo/weighted_errors.h"
#include "integrator/regions/region_layers.h"
#include "integrator/regions/surface_edges.h"
#include "integrator/selective/brightness_pilot.h"
#include "integrator/selective/chain_archive.h"
#include "integrator/selective/chain_check.h"
#include "integrator/selective/chain_scheduler.h"
#include "integrator/selective/division_pilot.h"
#include "integrator/selective/report.h"
#include "integrator/selective/technique_pilot.h"

namespace ajar {

namespace {

/// Tests for surfaces that are asked for, wherever chains pay.
bool shows_surfaces(const SelectiveConfig& config) {
  const std::vector<std::string>& aovs = config.settings.aovs;
  return config.antialias || !config.regions.empty() ||
         std::any_of(kRegionLayers.begin(), kRegionLayers.end(), [&](const char* layer) {
           return std::find(aovs.begin(), aovs.end(), layer) != aovs.end();
         });
}

/// The method, stage by stage:
///
///     brightness   a sample of each square of pixels: the importance map, the scale of thresholds
///     dark         if that was black: samples with manifold connections
///     techniques   which techniques ordinary Monte Carlo and chains share, and how many light
///                  paths
///     division     the first samples of the render: which light is for chains (region_choice.h);
///                  what they leave to chains seeds these
///     surfaces     where chains might pay: the regions of the picture, each divided by itself
///     render       samples and mutations, side by side, in epochs. At the end of each the seeds
///                  found meanwhile are merged into the chains (SeedReservoir), and effort is
///                  shared anew (SampleAllocation), and rays priced (EfficientRoulette).
class SelectiveIntegrator final : public Integrator {
 public:
  SelectiveIntegrator(const Scene& scene, const RenderSettings& settings,
                      const Parameters& parameters);

  PreparationRound begin_preparation(int round) override;
  void prepare_item(int round, std::uint64_t item, Counters& counters) override;
  void skip_preparation(PreparationCut of) override;
  std::vector<float> take_first_look() override { return std::exchange(first_look_, {}); }
  Findings findings() const override;

  std::vector<LayerSpec> layers() const override;
  std::uint64_t items_in_round() const override { return omc_items() + scheduler_.count(); }
  void begin_pass(std::uint64_t first_sample, std::uint64_t samples, Film& film) override;
  void run_item(std::uint64_t item, std::uint64_t first_sample, std::uint64_t samples, Film& film,
                Counters& counters) override;
  bool is_of_chains(std::uint64_t item) const override { return item >= omc_items(); }
  DevelopScale develop_scale(const LayerSpec& layer, std::uint64_t samples,
                             std::optional<int> replicate) const override;
  MethodReport report() const override { return report_on(status()); }

  bool keeps_state() const override { return !populations_.empty() || prepared_.roulette; }
  void save_state(OutputArchive& archive) const override;
  void load_state(InputArchive& archive, std::uint64_t samples) override;
  void export_delta(OutputArchive& archive, const WorkSlice& slice) override;
  void import_delta(InputArchive& archive, const WorkSlice& slice) override;
  std::uint64_t memory_bytes() const override;

 private:
  /// A stage of the preparation, and what becomes of its result.
  struct Stage {
    std::unique_ptr<PreparationStage> run;
    std::function<void()> take;
  };
  template <typename S>
  void add_stage(std::unique_ptr<S> stage, void (SelectiveIntegrator::*take)(S&));

  void take_brightness(BrightnessPilot& pilot);
  void take_dark(DarkPilot& pilot);
  void make_roulette(double magnitude);
  void take_techniques(TechniquePilot& pilot);
  void take_surfaces(SurfacePilot& pilot);
  void take_division(DivisionPilot& pilot);
  void add_surfaces();
  void divide();
  /// Mutations per camera sample until errors of the render are known.
  double first_mutations() const;
  PreparationRound describe(const PreparationStage& stage, std::uint64_t items) const;
  void leave_nothing_to_chains();
  void end_preparation();
  /// Renders without chains.
  void disable_chains(std::optional<PreparationCut> preparation_cut);
  void make_omc();

  /// Replicates of ordinary Monte Carlo's part after `samples` samples.
  Replicates pictures_of_omc(std::uint64_t samples, const Film& film) const;
  /// Roulette learns from that.
  void end_roulette_round(std::uint64_t samples, const Film& film);
  /// Shares effort anew by the errors that replicates show after `samples` samples.
  void share_effort(std::uint64_t samples, const Film& film);
  void begin_epoch();
  void end_epoch(const Film& film);
  /// b over all replicates; 1 if it is not known.
  double brightness_of_chains() const;
  std::uint64_t omc_items() const { return omc_->items_in_round(); }
  SelectiveStatus status() const {
    return {prepared_,
            division_ != nullptr && division_->result() ? &*division_->result() : nullptr,
            populations_, allocation_};
  }

  SelectivePreparation prepared_;
  std::vector<float> first_look_;
  std::vector<Stage> stages_;
  std::size_t stage_ = 0;                     ///< the running one
  DivisionPilot* division_ = nullptr;         ///< one of the stages; null if nothing is divided
  std::unique_ptr<SeedReservoir> reservoir_;  ///< null if there are no chains
  std::vector<ChainPopulation> populations_;
  SampleAllocation allocation_{prepared_};
  Epoch epoch_;
  ChainScheduler scheduler_{prepared_, allocation_, populations_, epoch_};
  std::unique_ptr<Integrator> omc_;
  std::uint64_t doubled_at_ = 0;  ///< samples per pixel
};

// ---------------------------------------------------------------- stages

SelectiveIntegrator::SelectiveIntegrator(const Scene& scene, const RenderSettings& settings,
                                         const Parameters& parameters)
    : prepared_(SelectiveConfig(scene, settings, parameters)) {
  if (!prepared_.config.has_long_paths() || prepared_.groups().empty()) {
    disable_chains(std::nullopt);
    return;
  }
  reservoir_ = std::make_unique<SeedReservoir>(prepared_);
  add_stage(std::make_unique<BrightnessPilot>(prepared_), &SelectiveIntegrator::take_brightness);
  add_stage(std::make_unique<DarkPilot>(prepared_), &SelectiveIntegrator::take_dark);
  add_stage(std::make_unique<TechniquePilot>(prepared_), &SelectiveIntegrator::take_techniques);
  prepared_.surfaces = one_region(settings.crop);
  if (shows_surfaces(prepared_.config)) add_surfaces();
  auto division = std::make_unique<DivisionPilot>(prepared_, *reservoir_);
  division_ = division.get();
  add_stage(std::move(division), &SelectiveIntegrator::take_division);
}

template <typename S>
void SelectiveIntegrator::add_stage(std::unique_ptr<S> stage,
                                    void (SelectiveIntegrator::*take)(S&)) {
  S& own = *stage;
  stages_.push_back({std::move(stage), [this, take, &own] { (this->*take)(own); }});
}

void SelectiveIntegrator::take_brightness(BrightnessPilot& pilot) {
  BrightnessPilot::Result result = pilot.take();
  prepared_.brightness = result.brightness;
  prepared_.view.importance = std::move(result.importance);
  prepared_.scale = result.scale;
  first_look_ = std::move(result.first_look);
}

void SelectiveIntegrator::take_dark(DarkPilot& pilot) {
  if (!(prepared_.brightness > 0.0)) prepared_.brightness = pilot.brightness();
  if (prepared_.brightness > 0.0) {
    prepared_.divisions.emplace(Division(prepared_.lowest_threshold(), prepared_.view.importance));
  } else {
    disable_chains(std::nullopt);
  }
}

void SelectiveIntegrator::make_roulette(double magnitude) {
  const RenderSettings& settings = prepared_.config.settings;
  if (!prepared_.has_efficient_roulette() || settings.replicates < 2) return;
  prepared_.roulette =
      std::make_unique<EfficientRoulette>(prepared_.scene().bounds(), settings.crop, magnitude);
}

void SelectiveIntegrator::take_techniques(TechniquePilot& pilot) {
  if (pilot.chosen()) {
    prepared_.techniques = choose_techniques(prepared_.config, *pilot.chosen());
  }
  make_roulette(prepared_.scale ? prepared_.scale->mean : prepared_.brightness);
}

void SelectiveIntegrator::add_surfaces() {
  add_stage(
      std::make_unique<SurfacePilot>(prepared_.scene(), beside_chains(prepared_.config.settings)),
      &SelectiveIntegrator::take_surfaces);
}

void SelectiveIntegrator::take_surfaces(SurfacePilot& pilot) {
  prepared_.surfaces = pilot.take();
  if (!division_->result()) return;
  division_->refine();
  divide();
}

void SelectiveIntegrator::take_division(DivisionPilot& pilot) {
  if (pilot.wants_regions() && !shows_surfaces(prepared_.config)) {
    add_surfaces();
  } else {
    divide();
  }
}

void SelectiveIntegrator::divide() {
  DivisionPilot& pilot = *division_;
  pilot.close();
  const DivisionResult& result = *pilot.result();
  if (pilot.stays()) prepared_.pilot_kept = result.samples;
  prepared_.pilot_tried = result.samples * prepared_.pixels();
  if (result.divisions.take_nothing()) {
    prepared_.mutations = 0.0;
    leave_nothing_to_chains();
    return;
  }
  const Divisions before = *std::exchange(prepared_.divisions, result.divisions);
  reservoir_->divide_anew(before);
  prepared_.fireflies_only = result.fireflies_only;
  prepared_.mutations = clamp_mutations(first_mutations());
  populations_ = make_populations<ChainPopulation>(
      prepared_.groups(), prepared_.config.settings.replicates, prepared_.config.settings.seed);
  if (pilot.stays()) {
    reservoir_->merge(populations_, 0, result.samples);
  } else {
    reservoir_->merge_unassigned(populations_, pilot.seeding_samples());
  }
}

double SelectiveIntegrator::first_mutations() const {
  const double light = reservoir_->energy() / division_->seeding_samples();
  return SelectiveHeuristics::kExpectedMutations * std::min(1.0, light / prepared_.brightness);
}

PreparationRound SelectiveIntegrator::begin_preparation(int round) {
  const auto end_stage = [this] {
    Stage& stage = stages_[stage_++];
    stage.run->end();
    const auto take = stage.take;
    take();
  };
  if (round > 0 && stage_ < stages_.size()) end_stage();
  while (stage_ < stages_.size() && division_ != nullptr) {
    const std::uint64_t items = stages_[stage_].run->begin();
    if (items > 0) return describe(*stages_[stage_].run, items);
    end_stage();
  }
  if (division_ != nullptr) end_preparation();
  return {};
}

PreparationRound SelectiveIntegrator::describe(const PreparationStage& stage,
                                               std::uint64_t items) const {
  PreparationRound round{.items = items,
                         .effort = stage.effort(),
                         .stays = stage.stays(),
                         .serves_alone = stage.serves_alone(),
                         .sample_effort = effort_of(prepared_.techniques.omc)};
  for (std::size_t i = stage_ + 1; i < stages_.size(); ++i) {
    const PreparationStage& later = *stages_[i].run;
    round.later_effort += later.effort();
    if (later.stays()) round.later_kept_effort += later.effort();
  }
  return round;
}

void SelectiveIntegrator::prepare_item(int /*round*/, std::uint64_t item, Counters& counters) {
  stages_[stage_].run->run(item, counters);
}

void SelectiveIntegrator::skip_preparation(PreparationCut of) {
  if (division_ != nullptr) disable_chains(of);
}

/// A pilot that is over stays in the picture if it may.
void SelectiveIntegrator::disable_chains(std::optional<PreparationCut> preparation_cut) {
  const bool is_kept = division_ != nullptr && division_->result() && division_->stays();
  prepared_.preparation_cut = preparation_cut;
  // The sums that are kept are in its units. Otherwise items may have been cut off, which have told
  // roulette of their rays.
  if (!is_kept) {
    prepared_.scale.reset();
    prepared_.roulette.reset();
  }
  prepared_.mutations = 0.0;
  prepared_.pilot_kept = is_kept ? division_->result()->samples : 0;
  if (prepared_.config.has_long_paths()) leave_nothing_to_chains();
  // The running stage is one of them.
  if (!is_kept) division_ = nullptr;
  stage_ = stages_.size();
  reservoir_.reset();
  populations_.clear();
  make_omc();
}

void SelectiveIntegrator::leave_nothing_to_chains() {
  prepared_.divisions.emplace(Division(
      prepared_.config.settings.crop,
      {{.threshold = 0.F, .target_scale = 0.F, .deposit_scale = 0.F}}, prepared_.view.importance));
}

void SelectiveIntegrator::end_preparation() {
  if (prepared_.mutations == 0.0) reservoir_.reset();
  make_omc();
  scheduler_.list();
  if (reservoir_) begin_epoch();
}

void SelectiveIntegrator::make_omc() {
  const RenderSettings settings = beside_chains(prepared_.config.settings);
  const bool has_chains = reservoir_ != nullptr;
  if (!prepared_.roulette) {
    if (!prepared_.scale) {
      prepared_.scale =
          measure_scale(prepared_.scene(), settings,
                        SelectivePreparation::omc_parameters(prepared_.techniques.omc));
    }
    make_roulette(prepared_.scale->mean);
  }
  PathIntegratorContext context{
      .divisions = prepared_.divisions ? &*prepared_.divisions : nullptr,
      .strong = reservoir_.get(),
      .joins_by_manifolds = has_chains && PathSeeds::any_has_manifolds(prepared_.groups())};
  omc_ = prepared_.make_omc(prepared_.techniques.omc, settings, context);
}

Findings SelectiveIntegrator::findings() const {
  Findings found = omc_->findings();
  const SelectiveStatus now = status();
  const bool is_divided = now.division != nullptr;
  if (!prepared_.groups().empty()) found.notes = notes_on(now);
  if (!is_divided) {
    found.maps =
        black_region_layers(prepared_.config.settings.aovs, prepared_.config.settings.crop);
    return found;
  }
  const Plane importance = chain_importance(prepared_);
  found.maps = region_layers(prepared_.config.settings.aovs, prepared_.surfaces,
                             now.division->noise, importance);
  if (prepared_.config.antialias) {
    found.antialias_mask = edges_of_map(prepared_.surfaces.edges, importance);
  }
  return found;
}

// ---------------------------------------------------------------- render

double SelectiveIntegrator::brightness_of_chains() const {
  double b = 0.0;
  for (const ChainPopulation& population : populations_) b += population.b.total;
  b /= prepared_.config.settings.replicates;
  return b > 0.0 && std::isfinite(b) ? b : 1.0;
}

std::vector<LayerSpec> SelectiveIntegrator::layers() const {
  std::vector<LayerSpec> specs = omc_->layers();
  for (LayerSpec& spec : specs) {
    if (spec.name == "indirect" || spec.box_of == "indirect") {
      spec.magnitude = brightness_of_chains();
    }
  }
  add_chain_layers(specs, prepared_.config.settings.aovs);
  return specs;
}

/// Seeds join and effort is shared at counts fixed in advance, which passes do not cross (see
/// `PassSchedule`): where passes end otherwise is up to the clock, and must not change the picture.
void SelectiveIntegrator::begin_pass(std::uint64_t first_sample, std::uint64_t samples,
                                     Film& film) {
  if (first_sample == 0 && division_ != nullptr) {
    division_->hand_over(film);
    if (prepared_.pilot_kept > 0) end_roulette_round(0, film);
  }
  if (reservoir_) {
    reservoir_->advance(populations_, allocation_.omc_samples(epoch_.begin()),
                        allocation_.omc_samples(first_sample),
                        allocation_.omc_samples(epoch_.end()));
    if (first_sample >= epoch_.end()) end_epoch(film);
    if (first_sample + samples > epoch_.end()) {
      throw std::logic_error("bug: a pass crosses a milestone");
    }
    return;
  }
  const std::uint64_t milestone =
      last_doubling(first_sample, static_cast<std::uint64_t>(prepared_.config.settings.replicates));
  if (milestone <= doubled_at_) return;
  doubled_at_ = milestone;
  share_effort(first_sample, film);
}

void SelectiveIntegrator::end_epoch(const Film& film) {
  reservoir_->merge(populations_, allocation_.omc_samples(epoch_.begin()),
                    allocation_.omc_samples(epoch_.end()));
  scheduler_.list();
  share_effort(epoch_.end(), film);
  begin_epoch();
}

void SelectiveIntegrator::begin_epoch() {
  const auto replicates = static_cast<std::uint64_t>(prepared_.config.settings.replicates);
  epoch_.go_on(milestone_after(epoch_.end(), replicates),
               populations_.front().samples_behind / static_cast<double>(prepared_.pixels()));
  reservoir_->set_rate(populations_, static_cast<double>(allocation_.omc_samples(epoch_.end()) -
                                                         allocation_.omc_samples(epoch_.begin())));
}

void SelectiveIntegrator::share_effort(std::uint64_t samples, const Film& film) {
  if (film.replicates() < 2) return;
  end_roulette_round(samples, film);
  if (!allocation_.can_adjust()) return;
  const Box2i& crop = prepared_.config.settings.crop;
  const ImportanceMap& importance = prepared_.view.importance;
  const auto errors = [&](const Replicates& pictures) {
    return weighted_errors(pictures, crop, importance);
  };
  allocation_.adjust(samples, errors(pictures_of_omc(samples, film)),
                     errors(develop_layers(film, *this, samples, {"indirect"})));
}

Replicates SelectiveIntegrator::pictures_of_omc(std::uint64_t samples, const Film& film) const {
  return develop_layers(film, *this, samples,
                        {"direct", prepared_.divisions ? kWeakLayer : "indirect"});
}

void SelectiveIntegrator::end_roulette_round(std::uint64_t samples, const Film& film) {
  if (!prepared_.roulette) return;
  const Box2i& crop = prepared_.config.settings.crop;
  const Replicates pictures = pictures_of_omc(samples, film);
  const Replicates whole =
      prepared_.divisions ? develop_layers(film, *this, samples, {"direct", kWeakLayer, "indirect"})
                          : pictures;
  const ImportanceMap importance = prepared_.config.relative_importance
                                       ? relative_importance(whole, crop)
                                       : prepared_.view.importance;
  prepared_.roulette->end_round(
      importance,
      weighted_errors(pictures, crop, importance).of_sample(allocation_.omc_samples(samples)));
}

void SelectiveIntegrator::run_item(std::uint64_t item, std::uint64_t first_sample,
                                   std::uint64_t samples, Film& film, Counters& counters) {
  if (item >= omc_items()) {
    scheduler_.run(item - omc_items(), first_sample, samples, film, counters);
    return;
  }
  omc_->run_item(item, allocation_.omc_samples(first_sample), samples, film, counters);
  allocation_.count_omc(counters.rays, counters.samples);
}

DevelopScale SelectiveIntegrator::develop_scale(const LayerSpec& layer, std::uint64_t samples,
                                                std::optional<int> replicate) const {
  if (layer.name == kDensityLayer) {
    const double mutations = allocation_.mutations(samples);
    return mutations > 0.0 ? 1.0 / mutations : 0.0;
  }
  if (layer.name == kAcceptanceLayer) return samples > 0 ? 1.0 / static_cast<double>(samples) : 0.0;
  if (layer.name != "indirect" || prepared_.preparation_cut) {
    return omc_->develop_scale(layer, allocation_.omc_samples(samples), replicate);
  }
  if (samples == 0) return 0.0;
  const double scale = 1.0 / epoch_.weight_until(samples);
  return replicate ? scale * prepared_.config.settings.replicates : scale;
}

// ---------------------------------------------------------------- state

void SelectiveIntegrator::save_state(OutputArchive& archive) const {
  archive(static_cast<std::uint64_t>(populations_.size()), doubled_at_, epoch_);
  for (const ChainPopulation& population : populations_) {
    serialize_population(archive, population, prepared_);
  }
  allocation_.save_state(archive);
  if (prepared_.roulette) prepared_.roulette->save_state(archive);
  if (reservoir_) reservoir_->save_state(archive);
}

void SelectiveIntegrator::load_state(InputArchive& archive, std::uint64_t samples) {
  std::uint64_t populations = 0;
  archive(populations, doubled_at_, epoch_);
  if (populations != populations_.size()) {
    throw std::runtime_error("corrupt checkpoint: number of populations");
  }
  const auto replicates = static_cast<std::uint64_t>(prepared_.config.settings.replicates);
  if (doubled_at_ > samples || !epoch_.can_be_at(samples, reservoir_ ? replicates : 0)) {
    throw std::runtime_error("corrupt checkpoint: wrong pass");
  }
  for (ChainPopulation& population : populations_) {
    serialize_population(archive, population, prepared_);
    check_population(population, prepared_, samples);
  }
  allocation_.load_state(archive, samples);
  if (prepared_.roulette) prepared_.roulette->load_state(archive);
  if (reservoir_) reservoir_->load_state(archive);
  scheduler_.list();
}

void SelectiveIntegrator::export_delta(OutputArchive& archive, const WorkSlice& slice) {
  scheduler_.export_delta(archive, slice, omc_items());
  allocation_.export_delta(archive);
  if (prepared_.roulette) prepared_.roulette->export_delta(archive);
  if (reservoir_) reservoir_->export_delta(archive);
}

void SelectiveIntegrator::import_delta(InputArchive& archive, const WorkSlice& slice) {
  scheduler_.import_delta(archive, slice, omc_items());
  allocation_.import_delta(archive);
  if (prepared_.roulette) prepared_.roulette->import_delta(archive);
  if (reservoir_) reservoir_->import_delta(archive);
}

std::uint64_t SelectiveIntegrator::memory_bytes() const {
  std::uint64_t bytes = prepared_.roulette ? prepared_.roulette->memory_bytes() : 0;
  for (const ChainPopulation& population : populations_) {
    for (const SelectiveChain& member : population.chains) {
      // There is one seed per chain, on average, which is as large.
      bytes += 2 * member.memory_bytes() + sizeof(SelectiveChain) - sizeof(member.state);
    }
  }
  return bytes;
}

}  // namespace

std::unique_ptr<Integrator> make_selective_integrator(const Scene& scene,
                                                      const RenderSettings& settings,
                                                      const Parameters& parameters) {
  return std::make_unique<SelectiveIntegrator>(scene, settings, parameters);
}

}  // namespace ajar
