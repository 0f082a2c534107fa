#include "integrator/selective/division_pilot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <tuple>

#include "core/random.h"
#include "core/random_use.h"
#include "integrator/division.h"
#include "integrator/make_filter.h"
#include "integrator/regions/surface_edges.h"
#include "integrator/selective/chain_bootstrap.h"
#include "integrator/selective/chain_share.h"
#include "integrator/selective/heuristics.h"

namespace ajar {

namespace {

/// What chains make of a path that brings as much as the whole of its pixel, relative to what they
/// might at most.
float chain_share(const PixelShare& share, const ChainPlan& plan) {
  const auto whole = static_cast<float>(plan.brightness);
  return share.kept * Division::above(whole, share.threshold) /
         Division::above(whole, static_cast<float>(plan.lowest_threshold()));
}

FoundLight light_of(const StrongPath& path, float energy) {
  return {.sample = path.sample,
          .raster = path.raster,
          .value = path.value,
          .strength = path.strength,
          .energy = energy,
          .weight = 1.F,
          .replicate = static_cast<std::int16_t>(path.replicate),
          .s = static_cast<std::int16_t>(path.technique.s),
          .t = static_cast<std::int16_t>(path.technique.t)};
}

}  // namespace

/// Keeps strong light to be divided anew, and offers it to chains. For maps of regions, it also
/// puts it on the pilot's film, where the noise is looked for.
class DivisionPilot::Sink final : public StrongPathSink {
 public:
  Sink(const DivisionPilot& pilot, Film& film, Counters& counters)
      : pilot_(pilot),
        film_(film),
        counters_(counters),
        layer_(film.layer("indirect")),
        recruits_(pilot.recruits_ != nullptr ? pilot.recruits_->make(film, counters) : nullptr) {}
  ~Sink() override {
    const std::lock_guard lock(pilot_.mutex_);
    pilot_.found_.insert(pilot_.found_.end(), found_.begin(), found_.end());
  }
  Sink(const Sink&) = delete;
  Sink& operator=(const Sink&) = delete;

  bool spread(SampleSource& numbers, StrongPath& path) override {
    if (pilot_.plan_.selective && !film_.splat(layer_, path.replicate, path.raster, path.value)) {
      ++counters_.discarded_infinite;
      return true;
    }
    StrongPath offered = path;
    if (offer(numbers, offered)) {
      if (pilot_.divides_anew()) keep(path);
    } else {
      keep_whole(offered);
    }
    return true;
  }

 private:
  /// False if chains cannot make it.
  bool offer(SampleSource& numbers, StrongPath& path) const {
    if (!recruits_ || !pilot_.offers(path.replicate)) return true;
    const double weight =
        draw_lot(path.energy, recruits_->grain(), hash_numbers(path.key(), RandomUse::RecruitLot));
    if (weight == 0.0) return true;
    path.value *= static_cast<float>(weight);
    path.energy *= weight;
    return recruits_->spread(numbers, path);
  }

  void keep_whole(const StrongPath& path) {
    found_.push_back(light_of(path, 0.F));
    found_.back().whole = true;
  }

  /// Of paths that carry little, only some: the others stand behind them.
  void keep(const StrongPath& path) {
    const PixelShare& share = pilot_.plan_.divisions->of(path.replicate).at(path.raster);
    const float above = Division::above(path.strength, share.threshold);
    const auto energy = static_cast<float>(path.energy);
    FoundLight light = light_of(path, energy / above);
    light.weight =
        static_cast<float>(draw_lot(static_cast<double>(energy), static_cast<double>(pilot_.grain_),
                                    hash_numbers(path.key(), RandomUse::LightLot)));
    if (light.weight == 0.F) return;
    light.value *= light.weight;
    found_.push_back(light);
  }

  const DivisionPilot& pilot_;
  Film& film_;
  Counters& counters_;
  int layer_;
  std::unique_ptr<StrongPathSink> recruits_;
  std::vector<FoundLight> found_;
};

int DivisionPilot::replicates() const {
  constexpr int kReplicates = 4;
  return stays() ? plan_.settings.replicates : kReplicates;
}

std::uint64_t DivisionPilot::planned_samples() const {
  const auto of_each = static_cast<std::uint64_t>(replicates());
  return std::max<std::uint64_t>(1, (plan_.pilot_samples + of_each - 1) / of_each) * of_each;
}

double DivisionPilot::effort() const {
  return static_cast<double>(planned_samples()) *
         ChainPlan::effort_with(plan_.omc.light_paths_per_pixel);
}

std::uint64_t DivisionPilot::begin() {
  if (!(plan_.brightness > 0.0)) return 0;
  if (!plan_.divisions) plan_.divisions.emplace(Division(0.0, plan_.view.importance));
  RenderSettings settings = plan_.omc_settings();
  settings.replicates = replicates();
  if (!stays()) {
    settings.seed = hash_numbers(settings.seed, RandomUse::DivisionPilot);
    settings.aovs.clear();
  }
  samples_ = planned_samples();
  grain_ = static_cast<float>(SelectiveHeuristics::kGrain * plan_.brightness);
  if (recruits_ != nullptr) recruits_->expect_unknown(static_cast<double>(samples_));
  omc_ = plan_.make_omc(settings, plan_.omc_depths(),
                        {.divisions = &*plan_.divisions, .strong = this});
  film_ = std::make_unique<Film>(settings.resolution, settings.crop,
                                 make_filter(plan_.scene.film().filter), settings.replicates,
                                 omc_->layers());
  return omc_->items_in_round();
}

void DivisionPilot::run(std::uint64_t item, Counters& counters) {
  Counters own;
  omc_->run_item(item, 0, samples_, *film_, own);
  rays_ += own.rays;
  counters.add_rays(own);
}

std::unique_ptr<StrongPathSink> DivisionPilot::make(Film& film, Counters& counters) const {
  return std::make_unique<Sink>(*this, film, counters);
}

bool DivisionPilot::divides_anew() const { return plan_.selective || plan_.chooses_thresholds(); }

bool DivisionPilot::offers(int replicate) const {
  // If the pilot does not stay, one half is for the map and the other for chains.
  return stays() || replicate % 2 == 1;
}

std::vector<int> DivisionPilot::seen_by(std::size_t half) const {
  const PilotUse use = plan_.pilot_use;
  std::vector<int> seen;
  for (int r = 0; r < film_->replicates(); ++r) {
    const bool is_odd = r % 2 == 1;
    const bool sees = use == PilotUse::Keep || (use == PilotUse::Cross && is_odd == (half == 0)) ||
                      (use == PilotUse::Discard && !is_odd);
    if (sees) seen.push_back(r);
  }
  return seen;
}

Division DivisionPilot::division_of(const RegionChoice& choice) const {
  std::vector<PixelShare> shares;
  shares.reserve(regions_.labels.size());
  for (const std::uint32_t label : regions_.labels) shares.push_back(choice.shares[label]);
  if (plan_.selective) {
    const std::vector<float>& painted = plan_.selective->painted;
    for (std::size_t i = 0; i < painted.size(); ++i) {
      shares[i].target = painted[i];
      const float whole = painted[i] > 0.5F ? 1.F : 0.F;
      shares[i].kept = plan_.selective->exclusive ? whole : painted[i];
    }
  }
  return {plan_.settings.crop, std::move(shares), plan_.view.importance};
}

void DivisionPilot::end() {
  if (!film_) return;
  rays_per_sample_ =
      static_cast<double>(rays_.load()) / static_cast<double>(samples_ * plan_.pixels());
  // Threads have found them in any order.
  std::stable_sort(found_.begin(), found_.end(), [](const FoundLight& a, const FoundLight& b) {
    return std::tie(a.sample, a.t, a.s) < std::tie(b.sample, b.t, b.s);
  });
  find_regions();
  decide();
}

void DivisionPilot::find_regions() {
  const Vec2i size(film_->width(), film_->height());
  regions_ =
      connected_regions(size, surfaces_ != nullptr ? surfaces_->identities()
                                                   : std::vector<PixelIdentity>(plan_.pixels()));
}

PilotView DivisionPilot::view(std::vector<int> replicates) const {
  return {plan_,    regions_,         *film_, *omc_,
          samples_, rays_per_sample_, found_, std::move(replicates)};
}

void DivisionPilot::decide() {
  for (std::size_t half = 0; half < halves(); ++half) {
    choices_.push_back(choose_regions(view(seen_by(half))));
  }
  std::vector<int> all(static_cast<std::size_t>(film_->replicates()));
  std::iota(all.begin(), all.end(), 0);
  const PilotView whole = view(std::move(all));
  if (plan_.selective) noise_ = pilot_noise(whole);
  const Divisions before = *plan_.divisions;
  if (halves() > 1) {
    plan_.divisions.emplace(division_of(choices_[0]), division_of(choices_[1]));
  } else {
    plan_.divisions.emplace(division_of(choices_[0]));
  }
  if (divides_anew()) share_of_chains_ = chain_share(whole, *plan_.divisions);
  if (recruits_ != nullptr) recruits_->divide_anew(before);
  share_effort();
  if (recruits_ != nullptr) join();
  if (stays()) {
    plan_.pilot_kept = samples_;
  } else {
    found_ = {};
    film_.reset();
  }
  omc_.reset();
}

void DivisionPilot::share_effort() {
  if (!plan_.shares_effort) return;
  bool off = plan_.selective && plan_.selective->painted.empty();
  double mutations = 0.0;
  for (const RegionChoice& choice : choices_) {
    off = off && choice.off;
    mutations += choice.mutations / static_cast<double>(choices_.size());
  }
  plan_.standby = off;
  if (recruits_ != nullptr) mutations = first_mutations();
  const bool none = (off && plan_.thresholds.empty()) || plan_.divisions->take_nothing();
  plan_.mutations = none ? 0.0 : ChainPlan::clamp_mutations(mutations);
}

double DivisionPilot::first_mutations() const {
  const double light = recruits_->energy() / recruiting_samples();
  return SelectiveHeuristics::kExpectedMutations * std::min(1.0, light / plan_.brightness);
}

double DivisionPilot::recruiting_samples() const {
  const auto all = static_cast<double>(samples_ * plan_.pixels());
  // Else half of them are for the map.
  return stays() ? all : all / 2.0;
}

void DivisionPilot::join() {
  plan_.scouted = samples_ * plan_.pixels();
  populations_ = make_populations(plan_);
  if (stays()) {
    recruits_->join(populations_, 0, samples_);
  } else {
    recruits_->join_scattered(populations_, recruiting_samples());
  }
}

void DivisionPilot::hand_over(Film& film) {
  if (!film_) return;
  film.add_layers(*film_, std::array<std::string, 1>{"indirect"});
  const int weak = film.layer(kWeakLayer);
  const int strong = film.layer(kStrongLayer);
  const auto lowest = static_cast<float>(plan_.lowest_threshold());
  for (const FoundLight& found : found_) {
    const Division& division = plan_.divisions->of(found.replicate);
    // Beside the share below the lowest threshold, which is on the film already.
    const float above = Division::above(found.strength, lowest);
    const float left =
        found.whole ? 1.F
                    : (above - 1.F + division.omc_share(found.strength, found.raster)) / above;
    film.splat(weak, found.replicate, found.raster, found.value * left);
    if (strong >= 0) film.splat(strong, found.replicate, found.raster, found.value * -left);
  }
  found_ = {};
  film_.reset();
}

Plane DivisionPilot::importance() const {
  Plane plane(regions_.size);
  const int width = regions_.size.x;
  for (std::size_t i = 0; i < plane.values.size(); ++i) {
    const Vec2i pixel =
        plan_.settings.crop.min + Vec2i(static_cast<int>(i) % width, static_cast<int>(i) / width);
    const Vec2 middle = Vec2(pixel) + Vec2(0.5F, 0.5F);
    const float even = chain_share(plan_.divisions->of(0).at(middle), plan_);
    const float odd = chain_share(plan_.divisions->of(1).at(middle), plan_);
    plane.values[i] = 0.5F * (even + odd);
  }
  return plane;
}

std::vector<std::pair<std::string, Plane>> DivisionPilot::maps() const {
  std::vector<std::pair<std::string, Plane>> planes;
  if (!noise_) return planes;
  const auto wanted = [&](const std::string& name) {
    const auto& aovs = plan_.settings.aovs;
    return std::find(aovs.begin(), aovs.end(), name) != aovs.end();
  };
  if (wanted("noise")) planes.emplace_back("noise", *noise_);
  if (wanted("regions")) {
    std::vector<float> numbers(regions_.count());
    std::iota(numbers.begin(), numbers.end(), 1.F);
    planes.emplace_back("regions", fill_regions(regions_, numbers));
  }
  if (wanted("importance")) planes.emplace_back("importance", importance());
  if (wanted("edges")) planes.emplace_back("edges", surfaces_->edges());
  return planes;
}

std::optional<Plane> DivisionPilot::antialias_mask() const {
  if (!plan_.selective->antialias || choices_.empty()) return std::nullopt;
  return edges_of_map(surfaces_->edges(), importance());
}

std::vector<double> DivisionPilot::thresholds() const {
  std::vector<double> thresholds;
  for (const RegionChoice& choice : choices_) {
    const auto threshold = static_cast<double>(choice.shares.front().threshold);
    // To as many digits as users write.
    thresholds.push_back(std::round(threshold / plan_.brightness * 1e4) / 1e4);
  }
  return thresholds;
}

MethodReport DivisionPilot::expectations() const {
  MethodReport halves = MethodReport::array();
  for (const RegionChoice& choice : choices_) {
    double sum = 0.0;
    for (const std::uint32_t label : regions_.labels) {
      sum += std::log(static_cast<double>(choice.shares[label].threshold) / plan_.brightness);
    }
    halves.push_back({{"expected_error", choice.expected_error},
                      {"threshold", std::exp(sum / static_cast<double>(regions_.labels.size()))},
                      {"stands_by", choice.off}});
  }
  return halves;
}

MethodReport DivisionPilot::regions() const {
  MethodReport rows = MethodReport::array();
  if (choices_.empty()) return rows;
  // Of the pixels, which the user may have painted.
  std::vector<double> importances(regions_.count());
  const Plane of_pixels = importance();
  for (std::size_t i = 0; i < of_pixels.values.size(); ++i) {
    importances[regions_.labels[i]] += static_cast<double>(of_pixels.values[i]);
  }
  std::vector<std::size_t> order(regions_.count());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return regions_.pixel_counts[a] > regions_.pixel_counts[b];
  });
  const auto name_of = [](std::span<const std::string> names, std::uint32_t number) {
    return number > 0 ? names[number - 1] : std::string();
  };
  for (const std::size_t r : order) {
    const PixelIdentity& shown = regions_.identities[r];
    double noise = 0.0;
    for (const RegionChoice& choice : choices_) {
      noise += static_cast<double>(choice.noise[r]) / static_cast<double>(choices_.size());
    }
    const auto pixels = regions_.pixel_counts[r];
    rows.push_back({{"region", r + 1},
                    {"pixels", pixels},
                    {"object", name_of(plan_.scene.object_names(), shown.object)},
                    {"material", name_of(plan_.scene.material_names(), shown.material)},
                    {"noise", noise},
                    {"importance", importances[r] / static_cast<double>(pixels)}});
  }
  return rows;
}

}  // namespace ajar
