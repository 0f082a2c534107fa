#include "integrator/selective/chain_family.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/milestones.h"
#include "integrator/make_filter.h"
#include "integrator/metropolis/chain_film_sink.h"
#include "integrator/metropolis/path_seeds.h"
#include "integrator/montecarlo/blind_spots.h"
#include "integrator/montecarlo/path_family.h"
#include "integrator/selective/chain_archive.h"
#include "integrator/selective/chain_bootstrap.h"
#include "integrator/selective/chain_check.h"
#include "integrator/selective/chain_effort.h"
#include "integrator/selective/chain_items.h"
#include "integrator/selective/chain_pilot.h"
#include "integrator/selective/chain_plan.h"
#include "integrator/selective/chain_recruits.h"
#include "integrator/selective/chain_report.h"
#include "integrator/selective/chain_stretch.h"
#include "integrator/selective/division_pilot.h"
#include "integrator/selective/heuristics.h"
#include "integrator/selective/omc_adaptation.h"
#include "integrator/selective/plane_maps.h"
#include "integrator/selective/roulette_pilot.h"
#include "integrator/selective/surface_pilot.h"
#include "integrator/selective/technique_pilot.h"
#include "integrator/selective/weighted_errors.h"

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
  void skip_preparation(Shortage of) override;
  std::vector<float> take_first_look() override { return std::exchange(plan_.first_look, {}); }
  Findings findings() const override;

  std::vector<LayerSpec> layers() const override;
  std::uint64_t items_in_round() const override;
  void begin_pass(std::uint64_t first_sample, std::uint64_t samples, Film& film) override;
  void run_item(std::uint64_t item, std::uint64_t first_sample, std::uint64_t samples, Film& film,
                Counters& counters) override;
  bool is_of_chains(std::uint64_t item) const override { return item >= omc_items(); }
  DevelopScale develop_scale(const LayerSpec& layer, std::uint64_t samples,
                             std::optional<int> replicate) const override;
  MethodReport report() const override;

  bool keeps_state() const override { return !populations_.empty() || learns(); }
  void save_state(OutputArchive& archive) const override;
  void load_state(InputArchive& archive, std::uint64_t samples) override;
  void give_news(OutputArchive& archive, const WorkShare& share) override;
  void take_news(InputArchive& archive, const WorkShare& share) override;
  std::uint64_t memory_bytes() const override;

 private:
  std::vector<std::pair<std::string, Plane>> maps() const;
  /// What regions and their pilot tell.
  MethodReport report_regions() const;
  void end_preparation();
  /// Does without chains.
  void leave_to_omc(Shortage shortage);
  void make_omc();
  /// Whether chains start from manifold connections, too.
  bool joins_by_manifolds() const;
  void look_for_blind_spots();
  /// Whether ordinary Monte Carlo does, as the render goes on.
  bool learns() const { return adaptation_ && adaptation_->learns(); }
  /// By the errors that replicates show after `samples` samples: how much effort which half
  /// deserves, and where.
  void share_effort(std::uint64_t samples, const Film& film);
  /// Lets what ordinary Monte Carlo has found in the stretch that ends here join the chains.
  void join_recruits(const Film& film);
  /// Begins the next stretch.
  void begin_stretch();
  /// b as the bootstrap has it, over all replicates; 1 if it found no light.
  double bootstrap_b() const;
  /// Of a pass, before its chains.
  std::uint64_t omc_items() const { return omc_ ? omc_->items_in_round() : 0; }

  ChainPlan plan_;
  ChainEffort effort_{plan_};
  std::vector<std::unique_ptr<PreparationStage>> stages_;
  DivisionPilot* pilot_ = nullptr;  ///< one of the stages; null if there is nothing to decide
  std::size_t stage_ = 0;           ///< that is running
  std::vector<ChainPopulation> populations_;
  std::unique_ptr<OmcAdaptation> adaptation_;  ///< null if the next is
  std::unique_ptr<Integrator> omc_;            ///< null if it has nothing to render
  std::vector<Warning> concerns_;
  std::vector<Warning> blind_spots_;         ///< of chains
  std::unique_ptr<PlaneMaps> maps_;          ///< null if steps do not follow the image plane
  std::uint64_t doubled_at_ = 0;             ///< samples per pixel
  std::unique_ptr<ChainRecruits> recruits_;  ///< null unless ordinary Monte Carlo finds seeds
  ChainStretch stretch_;
  ChainItems items_{plan_, effort_, populations_, stretch_};
};

ChainIntegrator::ChainIntegrator(ChainKind kind, const Scene& scene, const RenderSettings& settings,
                                 const Parameters& parameters,
                                 std::optional<SelectiveSettings> selective)
    : plan_(kind, scene, settings, parameters, std::move(selective)) {
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
    const SurfacePilot* surfaces = nullptr;
    if (plan_.selective) {
      auto stage = std::make_unique<SurfacePilot>(plan_);
      surfaces = stage.get();
      stages_.push_back(std::move(stage));
    }
    auto pilot = std::make_unique<DivisionPilot>(plan_, populations_, surfaces, recruits_.get());
    pilot_ = pilot.get();
    stages_.push_back(std::move(pilot));
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
    PreparationRound next{.items = items,
                          .effort = stage.effort(),
                          .stays = stage.stays(),
                          .serves_alone = stage.serves_alone()};
    for (std::size_t i = stage_ + 1; i < stages_.size(); ++i) {
      next.later_effort += stages_[i]->effort();
      if (stages_[i]->stays()) next.later_stays += stages_[i]->effort();
    }
    // Whoever names mmlt+ or another of these wants chains; `selective` is to choose.
    if (plan_.selective) {
      next.sample_effort = ChainPlan::effort_with(plan_.omc.light_paths_per_pixel);
    }
    return next;
  }
  end_preparation();
  return {};
}

void ChainIntegrator::prepare_item(int /*round*/, std::uint64_t item, Counters& counters) {
  stages_[stage_]->run(item, counters);
}

void ChainIntegrator::skip_preparation(Shortage of) {
  if (stages_.empty()) return;
  leave_to_omc(of);
}

void ChainIntegrator::leave_to_omc(Shortage shortage) {
  const bool is_kept = pilot_ != nullptr && pilot_->is_over() && pilot_->stays();
  plan_.leave_to_omc(shortage, is_kept ? pilot_->samples() : 0);
  std::erase_if(stages_, [&](const std::unique_ptr<PreparationStage>& stage) {
    return plan_.pilot_kept == 0 || stage.get() != pilot_;
  });
  pilot_ = nullptr;
  recruits_.reset();
  populations_.clear();
  make_omc();
}

void ChainIntegrator::end_preparation() {
  const bool is_lit =
      std::any_of(populations_.begin(), populations_.end(),
                  [](const ChainPopulation& population) { return !population.chains.empty(); });
  const bool looks_on = plan_.divisions || std::any_of(plan_.groups.begin(), plan_.groups.end(),
                                                       [](const PathGroup& group) {
                                                         return !is_explicit(group.kind);
                                                       });
  // Its machinery goes on all the same: that nothing was found yet counts in b, which is right on
  // average over what is found and what is not.
  plan_.unlit = plan_.selective && !plan_.standby && plan_.mutations > 0.0 &&
                !populations_.empty() && !is_lit && looks_on;
  // With a black pilot there is nothing to divide by.
  if (!plan_.divisions || plan_.mutations == 0.0) recruits_.reset();
  if (plan_.mutations == 0.0) populations_.clear();
  make_omc();
  items_.list(recruits_ == nullptr);
  if (recruits_) begin_stretch();
  concerns_ = concerns_about(plan_, populations_);
  look_for_blind_spots();
  if (plan_.moves.plane.active()) {
    maps_ = std::make_unique<PlaneMaps>(plan_.moves.plane, plan_.view, plan_.settings.replicates,
                                        bootstrap_b(), *plan_.moves.mutation);
  }
}

Findings ChainIntegrator::findings() const {
  Findings found = omc_ ? omc_->findings() : Findings{};
  found.concerns.insert(found.concerns.begin(), concerns_.begin(), concerns_.end());
  found.concerns.insert(found.concerns.end(), blind_spots_.begin(), blind_spots_.end());
  found.misses_light = found.misses_light || !blind_spots_.empty();
  const bool might_have_chains = plan_.unprepared.has_value() || !plan_.groups.empty();
  if (might_have_chains && concerns_.empty()) {
    found.notes = notes_on(plan_, pilot_ != nullptr ? pilot_->share_of_chains() : std::nullopt,
                           recruits_ != nullptr);
  }
  if (plan_.selective) {
    found.maps = maps();
    if (pilot_ != nullptr) found.antialias_mask = pilot_->antialias_mask();
  }
  return found;
}

void ChainIntegrator::make_omc() {
  const std::pair<int, int> depths = plan_.omc_depths();
  if (depths.first > depths.second) return;
  const RenderSettings settings = plan_.omc_settings();
  adaptation_ = std::make_unique<OmcAdaptation>(plan_, settings);
  PathIntegratorContext context{.divisions = plan_.divisions ? &*plan_.divisions : nullptr,
                                .strong = recruits_.get(),
                                .joins_by_manifolds = joins_by_manifolds()};
  adaptation_->tell(context);
  omc_ = plan_.make_omc(settings, depths, context);
}

bool ChainIntegrator::joins_by_manifolds() const {
  return (recruits_ || !populations_.empty()) && PathSeeds::any_has_manifolds(plan_.groups);
}

/// Where the light is not divided path by path, ordinary Monte Carlo knows of short paths alone.
void ChainIntegrator::look_for_blind_spots() {
  if (plan_.divisions || populations_.empty()) return;
  PathSamplerSettings sampler = plan_.groups.front().sampler;
  sampler.max_depth = plan_.settings.max_depth;
  blind_spots_ = blind_spots(plan_.scene, plan_.settings, sampler, joins_by_manifolds());
}

MethodReport ChainIntegrator::report() const {
  MethodReport report = report_chains(plan_, populations_, items_.later_weight());
  if (pilot_ == nullptr) return report;
  if (plan_.selective) {
    report["selective"] = report_regions();
  } else {
    report["split"] = pilot_->thresholds();
  }
  return report;
}

MethodReport ChainIntegrator::report_regions() const {
  const auto or_null = [](std::optional<double> value) {
    return value && std::isfinite(*value) ? MethodReport(*value) : MethodReport();
  };
  MethodReport regions = pilot_->regions();
  const std::size_t count = regions.size();
  if (constexpr std::size_t kMost = SelectiveHeuristics::kMostRegionsTold; count > kMost) {
    regions.erase(regions.begin() + kMost, regions.end());
  }
  const ChainEffort::Known known = effort_.known();
  // Relative to the brightness of the picture; 0: rays have no price.
  double ray_price = 0.0;
  double path_rest = 0.0;
  if (adaptation_ && adaptation_->price()) {
    ray_price = adaptation_->price()->price() / plan_.brightness;
    path_rest = adaptation_->price()->rest() / plan_.brightness;
  }
  std::optional<double> omc_error;
  if (known.chain_error) omc_error = 1.0 - *known.chain_error;
  return {{"pilot_samples_per_pixel", pilot_->samples()},
          {"pilot_stays", plan_.pilot_kept > 0},
          {"halves", pilot_->expectations()},
          {"mutations_per_sample", known.mutations_per_sample},
          {"correlation", or_null(known.correlation)},
          {"chains",
           {{"ray_share", known.chain_rays}, {"squared_error_share", or_null(known.chain_error)}}},
          {"omc",
           {{"techniques", plan_.omc.techniques},
            {"light_paths_per_sample", plan_.omc.light_paths_per_pixel},
            {"ray_price", ray_price},
            {"path_rest", path_rest},
            {"ray_share", 1.0 - known.chain_rays},
            {"squared_error_share", or_null(omc_error)}}},
          {"region_count", count},
          {"regions", regions}};
}

std::vector<std::pair<std::string, Plane>> ChainIntegrator::maps() const {
  std::vector<std::pair<std::string, Plane>> planes;
  if (pilot_ != nullptr) planes = pilot_->maps();
  if (!planes.empty()) return planes;
  // Nothing had to be decided: there is no light for chains, or no time for a pilot.
  for (const char* name : kRegionLayers) {
    if (asks_for(plan_.settings.aovs, name)) {
      planes.emplace_back(name, Plane(plan_.settings.crop.size() + Vec2i(1, 1)));
    }
  }
  return planes;
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
      if (spec.name == "indirect" || spec.box_of == "indirect") spec.magnitude = magnitude;
    }
  } else {
    specs = light_layers(magnitude);
    if (plan_.settings.for_filters) add_box_layers(specs, make_filter(plan_.scene.film().filter));
  }
  add_chain_layers(specs, plan_.settings.aovs);
  return specs;
}

std::uint64_t ChainIntegrator::items_in_round() const { return omc_items() + items_.count(); }

/// b is refined, recruits join, and the maps of the image plane end an epoch, at counts fixed in
/// advance, which passes do not cross (see `PassSchedule`): where passes end otherwise is up to the
/// clock, and must not change the picture.
void ChainIntegrator::begin_pass(std::uint64_t first_sample, std::uint64_t samples, Film& film) {
  if (first_sample == 0) {
    items_.refine_b(0);
    for (const auto& stage : stages_) stage->hand_over(film);
  }
  if (recruits_) {
    recruits_->look_on(populations_, effort_.omc_samples(stretch_.begin()),
                       effort_.omc_samples(first_sample), effort_.omc_samples(stretch_.end()));
    if (first_sample >= stretch_.end()) join_recruits(film);
  }
  if (recruits_ && first_sample + samples > stretch_.end()) {
    throw std::logic_error("bug: a pass crosses a milestone");
  }
  const std::uint64_t milestone =
      last_doubling(first_sample, static_cast<std::uint64_t>(plan_.settings.replicates));
  if (milestone <= doubled_at_) return;
  doubled_at_ = milestone;
  if (!recruits_) {
    share_effort(first_sample, film);
    items_.refine_b(milestone);
  }
  if (maps_) maps_->end_epoch(effort_.mutations(milestone));
}

void ChainIntegrator::join_recruits(const Film& film) {
  recruits_->join(populations_, effort_.omc_samples(stretch_.begin()),
                  effort_.omc_samples(stretch_.end()));
  items_.list(false);
  items_.refine_b(stretch_.end());
  share_effort(stretch_.end(), film);
  begin_stretch();
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
  if (plan_.selective && plan_.selective->objective == SelectiveSettings::Objective::Filtered) {
    seen = {seen_light(by_omc, crop, importance), seen_light(by_chains, crop, importance)};
  }
  effort_.adjust(samples, of_omc, weighted_errors(by_chains, crop, importance), seen);
}

void ChainIntegrator::begin_stretch() {
  stretch_.go_on(
      milestone_after(stretch_.end(), static_cast<std::uint64_t>(plan_.settings.replicates)),
      populations_.front().samples_behind / static_cast<double>(plan_.pixels()));
  recruits_->expect(populations_, static_cast<double>(effort_.omc_samples(stretch_.end()) -
                                                      effort_.omc_samples(stretch_.begin())));
}

void ChainIntegrator::run_item(std::uint64_t item, std::uint64_t first_sample,
                               std::uint64_t samples, Film& film, Counters& counters) {
  if (item >= omc_items()) {
    items_.run(item - omc_items(), first_sample, samples, maps_.get(), film, counters);
    return;
  }
  const std::uint64_t first = effort_.omc_samples(first_sample);
  const std::uint64_t last = effort_.omc_samples(first_sample + samples);
  if (first == last) return;
  omc_->run_item(item, first, last - first, film, counters);
  effort_.count_omc(counters.rays, counters.samples);
}

void ChainIntegrator::save_state(OutputArchive& archive) const {
  archive(static_cast<std::uint64_t>(populations_.size()));
  items_.save_state(archive);
  archive(doubled_at_, stretch_);
  for (const ChainPopulation& population : populations_) {
    serialize_population(archive, population, plan_);
  }
  effort_.save_state(archive);
  if (adaptation_) adaptation_->save_state(archive);
  if (recruits_) recruits_->save_state(archive);
  if (maps_) maps_->save_state(archive);
}

void ChainIntegrator::load_state(InputArchive& archive, std::uint64_t samples) {
  std::uint64_t populations = 0;
  archive(populations);
  if (populations != populations_.size()) {
    throw std::runtime_error("other chains are prepared than there were");
  }
  items_.load_state(archive);
  archive(doubled_at_, stretch_);
  const auto replicates = static_cast<std::uint64_t>(plan_.settings.replicates);
  if (doubled_at_ > samples || !stretch_.can_be_at(samples, recruits_ ? replicates : 0)) {
    throw std::runtime_error("chains of another time");
  }
  for (ChainPopulation& population : populations_) {
    serialize_population(archive, population, plan_);
    check_population(population, plan_, samples);
  }
  items_.check_b();
  effort_.load_state(archive, samples);
  if (adaptation_) adaptation_->load_state(archive, effort_.omc_samples(samples));
  if (recruits_) recruits_->load_state(archive);
  if (maps_) maps_->load_state(archive);
  items_.list(recruits_ == nullptr);
}

void ChainIntegrator::give_news(OutputArchive& archive, const WorkShare& share) {
  items_.give_news(archive, share, omc_items());
  effort_.give_news(archive);
  if (recruits_) recruits_->give_news(archive);
  if (maps_) maps_->give_news(archive);
}

void ChainIntegrator::take_news(InputArchive& archive, const WorkShare& share) {
  items_.take_news(archive, share, omc_items());
  effort_.take_news(archive);
  if (recruits_) recruits_->take_news(archive);
  if (maps_) maps_->take_news(archive);
}

std::uint64_t ChainIntegrator::memory_bytes() const {
  std::uint64_t bytes = maps_ ? maps_->memory_bytes() : 0;
  if (adaptation_) bytes += adaptation_->memory_bytes();
  for (const ChainPopulation& population : populations_) {
    for (const SelectiveChain& member : population.chains) {
      // Of recruits there is one per chain, on average, which is as large.
      bytes += (recruits_ ? 2 : 1) * member.memory_bytes();
      bytes += sizeof(SelectiveChain) - sizeof(member.state);
    }
  }
  return bytes;
}

DevelopScale ChainIntegrator::develop_scale(const LayerSpec& layer, std::uint64_t samples,
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
