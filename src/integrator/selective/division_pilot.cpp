#include "integrator/selective/division_pilot.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

#include "core/random.h"
#include "core/random_use.h"
#include "integrator/make_filter.h"
#include "integrator/metropolis/chain_film_sink.h"
#include "integrator/selective/chain_fraction.h"
#include "integrator/selective/heuristics.h"

namespace ajar {

namespace {

PilotPath light_of(const OutlierPath& path, float energy) {
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

/// Keeps outliers, to be divided anew, and offers them to chains. They are on the pilot's film,
/// too, whose noise is looked at.
class DivisionPilot::Sink final : public OutlierSink {
 public:
  Sink(const DivisionPilot& pilot, Film& film, Counters& counters)
      : pilot_(pilot),
        film_(film),
        counters_(counters),
        layer_(film.layer("indirect")),
        seeds_(pilot.reservoir_.make(film, counters)) {}
  ~Sink() override {
    const std::lock_guard lock(pilot_.mutex_);
    pilot_.found_.insert(pilot_.found_.end(), found_.begin(), found_.end());
  }
  Sink(const Sink&) = delete;
  Sink& operator=(const Sink&) = delete;

  bool spread(SampleSource& numbers, OutlierPath& path) override {
    if (!film_.splat(layer_, path.replicate, path.raster, path.value)) {
      ++counters_.discarded_infinite;
      return true;
    }
    OutlierPath offered = path;
    if (offer(numbers, offered)) {
      keep(path);
    } else {
      keep_whole(offered);
    }
    return true;
  }

 private:
  /// False if chains cannot make it.
  bool offer(SampleSource& numbers, OutlierPath& path) const {
    if (!pilot_.offers(path.replicate)) return true;
    const double weight = russian_roulette(path.energy, seeds_->threshold(),
                                           hash_numbers(path.key(), RandomUse::SeedRoulette));
    if (weight == 0.0) return true;
    path.value *= static_cast<float>(weight);
    path.energy *= weight;
    return seeds_->spread(numbers, path);
  }

  void keep_whole(const OutlierPath& path) {
    found_.push_back(light_of(path, 0.F));
    found_.back().whole = true;
  }

  /// Keeps a path, if it carries little only by Russian roulette.
  void keep(const OutlierPath& path) {
    const PixelDivision& division = pilot_.prepared_.divisions->of(path.replicate).at(path.raster);
    const float above = Division::chain_fraction(path.strength, division.threshold);
    const auto energy = static_cast<float>(path.energy);
    PilotPath light = light_of(path, energy / above);
    light.weight = static_cast<float>(
        russian_roulette(static_cast<double>(energy), static_cast<double>(pilot_.threshold_),
                         hash_numbers(path.key(), RandomUse::PilotRoulette)));
    if (light.weight == 0.F) return;
    light.value *= light.weight;
    found_.push_back(light);
  }

  const DivisionPilot& pilot_;
  Film& film_;
  Counters& counters_;
  int layer_;
  std::unique_ptr<OutlierSink> seeds_;
  std::vector<PilotPath> found_;
};

int DivisionPilot::replicates() const {
  constexpr int kReplicates = 4;
  return stays() ? prepared_.config.settings.replicates : kReplicates;
}

std::uint64_t DivisionPilot::planned_samples() const {
  const auto of_each = static_cast<std::uint64_t>(replicates());
  return std::max<std::uint64_t>(1, (prepared_.config.pilot_samples + of_each - 1) / of_each) *
         of_each;
}

double DivisionPilot::effort() const {
  return static_cast<double>(planned_samples()) * effort_of(prepared_.techniques.omc);
}

std::uint64_t DivisionPilot::begin() {
  RenderSettings settings = beside_chains(prepared_.config.settings);
  settings.replicates = replicates();
  if (!stays()) {
    settings.seed = hash_numbers(settings.seed, RandomUse::DivisionPilot);
    settings.aovs.clear();
  }
  samples_ = planned_samples();
  threshold_ = static_cast<float>(SelectiveHeuristics::kPilotRoulette * prepared_.brightness);
  reservoir_.set_initial_rate(static_cast<double>(samples_));
  omc_ = prepared_.make_omc(
      prepared_.techniques.omc, settings,
      {.divisions = &*prepared_.divisions, .strong = this, .is_undecided = true});
  may_disable_chains_ = prepared_.config.chooses_division && !omc_->findings().misses_light;
  film_ = std::make_unique<Film>(settings.resolution, settings.crop,
                                 make_filter(prepared_.scene().film().filter), settings.replicates,
                                 omc_->layers());
  return omc_->items_in_round();
}

void DivisionPilot::run(std::uint64_t item, Counters& counters) {
  Counters own;
  omc_->run_item(item, 0, samples_, *film_, own);
  rays_ += own.rays;
  counters.add_rays(own);
}

std::unique_ptr<OutlierSink> DivisionPilot::make(Film& film, Counters& counters) const {
  return std::make_unique<Sink>(*this, film, counters);
}

double DivisionPilot::seeding_samples() const {
  const auto all = static_cast<double>(samples_ * prepared_.pixels());
  return stays() ? all : all / 2.0;
}

std::vector<int> DivisionPilot::seen_by(std::size_t half) const {
  std::vector<int> seen;
  for (int r = 0; r < film_->replicates(); ++r) {
    const bool is_odd = r % 2 == 1;
    if (stays() ? is_odd == (half == 0) : !is_odd) seen.push_back(r);
  }
  return seen;
}

PilotView DivisionPilot::view(std::vector<int> replicates) const {
  const double rays =
      static_cast<double>(rays_.load()) / static_cast<double>(samples_ * prepared_.pixels());
  return {prepared_, *film_, *omc_, samples_, rays, found_, std::move(replicates)};
}

Division DivisionPilot::division_of(const RegionChoice& choice) const {
  std::vector<PixelDivision> pixels;
  const std::vector<std::uint32_t>& labels = prepared_.surfaces.regions.labels;
  pixels.reserve(labels.size());
  for (const std::uint32_t label : labels) pixels.push_back(choice.regions[label]);
  const std::vector<float>& painted = prepared_.config.regions.painted;
  for (std::size_t i = 0; i < painted.size(); ++i) {
    pixels[i].target_scale = painted[i];
    pixels[i].deposit_scale = painted[i];
  }
  return {prepared_.config.settings.crop, std::move(pixels), prepared_.view.importance};
}

void DivisionPilot::end() {
  // Threads have found them in any order.
  std::stable_sort(found_.begin(), found_.end(), [](const PilotPath& a, const PilotPath& b) {
    return std::tie(a.sample, a.t, a.s) < std::tie(b.sample, b.t, b.s);
  });
  std::vector<RegionChoice> choices;
  for (std::size_t half = 0; half < (stays() ? 2U : 1U); ++half) choices.push_back(choose(half));
  conclude(std::move(choices));
}

bool DivisionPilot::wants_regions() const {
  return std::any_of(result_->choices.begin(), result_->choices.end(),
                     [](const RegionChoice& choice) { return choice.has_hope(); });
}

void DivisionPilot::refine() {
  std::vector<RegionChoice> choices = std::move(result_->choices);
  for (std::size_t half = 0; half < choices.size(); ++half) {
    RegionChoice& choice = choices[half];
    if (choice.is_hopeless()) {
      choice.regions.assign(prepared_.surfaces.regions.count(), choice.regions.front());
    } else {
      choice = choose(half);
    }
  }
  conclude(std::move(choices));
}

RegionChoice DivisionPilot::choose(std::size_t half) const {
  RegionChoice choice = choose_regions(view(seen_by(half)));
  if (!may_disable_chains_ || !choice.is_hopeless()) return choice;
  return without_chains(std::move(choice), prepared_.surfaces.regions.count());
}

void DivisionPilot::conclude(std::vector<RegionChoice> choices) {
  const bool fireflies_only =
      prepared_.config.regions.painted.empty() &&
      std::all_of(choices.begin(), choices.end(),
                  [](const RegionChoice& choice) { return choice.fireflies_only; });
  Divisions divisions = choices.size() > 1
                            ? Divisions(division_of(choices[0]), division_of(choices[1]))
                            : Divisions(division_of(choices[0]));
  std::vector<int> all(static_cast<std::size_t>(film_->replicates()));
  std::iota(all.begin(), all.end(), 0);
  const PilotView whole = view(std::move(all));
  const double fraction = chain_fraction(whole, divisions);
  result_.emplace(DivisionResult{std::move(choices), std::move(divisions), fireflies_only,
                                 pilot_noise(whole), fraction, samples_});
}

void DivisionPilot::close() {
  omc_.reset();
  if (stays()) return;
  found_ = {};
  film_.reset();
}

void DivisionPilot::hand_over(Film& film) {
  if (!film_) return;
  film.add_layers(*film_, std::array<std::string, 1>{"indirect"});
  const int weak = film.layer(kWeakLayer);
  const int strong = film.layer(kStrongLayer);
  const auto lowest = static_cast<float>(prepared_.lowest_threshold());
  for (const PilotPath& found : found_) {
    const Division& division = prepared_.divisions->of(found.replicate);
    // Beside the share below the lowest threshold, which is on the film already.
    const float above = Division::chain_fraction(found.strength, lowest);
    const float left =
        found.whole ? 1.F
                    : (above - 1.F + division.omc_fraction(found.strength, found.raster)) / above;
    film.splat(weak, found.replicate, found.raster, found.value * left);
    if (strong >= 0) film.splat(strong, found.replicate, found.raster, found.value * -left);
  }
  found_ = {};
  film_.reset();
}

}  // namespace ajar
