#include "integrator/selective/technique_pilot.h"

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "core/random_use.h"
#include "image/visible_error.h"
#include "integrator/montecarlo/path_family.h"
#include "integrator/selective/heuristics.h"
#include "transport/sources.h"

namespace ajar {

namespace {

/// Work items, so that threads share the places.
constexpr std::uint64_t kTrialItems = 16;
/// Places on the film in each.
constexpr std::uint64_t kTrialPlaces = SelectiveHeuristics::kPilotPlaces / kTrialItems;

/// Techniques to choose from, from few rays to many.
std::vector<PathFamilyDefaults> technique_offers() {
  std::vector<PathFamilyDefaults> offers = {path_family_defaults("pt")};
  const auto add = [&](const char* techniques, double light_paths) {
    offers.push_back(path_family_defaults(techniques));
    offers.back().light_paths_per_pixel = light_paths;
  };
  for (const double light_paths : {0.1, 0.33, 1.0}) add("ibpt", light_paths);
  for (const double light_paths : {1.0, 4.0}) add("bdpt", light_paths);
  return offers;
}

/// Counts of classes over those of `bdpt` with one light subpath.
ByTechniqueClass<double> relative_counts(const PathFamilyDefaults& offer) {
  const TechniqueSet set = TechniqueSet::parse(offer.techniques);
  ByTechniqueClass<double> counts{};
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const auto kind = static_cast<TechniqueClass>(k);
    const bool by_light_paths = kind == TechniqueClass::Light || kind == TechniqueClass::Inner;
    counts[k] = set.count(kind) * (by_light_paths ? offer.light_paths_per_pixel : 1.0);
  }
  return counts;
}

/// Rays with other counts than those that were tried.
double rays_with(const ByTechniqueClass<double>& counts, double rays, const RaysByUse& by_use) {
  const double light = counts[index_of(TechniqueClass::Light)];
  const double inner = counts[index_of(TechniqueClass::Inner)];
  const auto walk = static_cast<double>(by_use.light_walk);
  const auto to_lens = static_cast<double>(by_use.connections[index_of(TechniqueClass::Light)]);
  const auto between = static_cast<double>(by_use.connections[index_of(TechniqueClass::Inner)]);
  return rays + (std::max(light, inner) - 1.0) * walk + (light - 1.0) * to_lens +
         (inner - 1.0) * between;
}

}  // namespace

class TechniquePilot::Sink final : public PathSink {
 public:
  Sink(const SelectivePreparation& prepared, TechniqueErrors& errors)
      : view_(prepared.view),
        most_(SelectiveHeuristics::kBright * prepared.brightness),
        errors_(errors) {}

  void begin_place(const Vec2& raster) {
    raster_ = raster;
    errors_.begin_place();
  }
  void add(const Contribution& contribution) override {
    const TechniqueClass found_by = class_of(contribution.technique);
    const float importance =
        view_.importance(found_by == TechniqueClass::Light ? contribution.raster : raster_);
    const auto light = static_cast<double>(luminance(contribution.value) * importance);
    errors_.add(std::min(light, most_), found_by, contribution.shares);
  }
  bool reaches(const Vec2& raster) const override { return view_.contains(raster); }

 private:
  const ChainView& view_;
  double most_;
  TechniqueErrors& errors_;
  Vec2 raster_{0.F, 0.F};
};

TechniquePilot::TechniquePilot(const SelectivePreparation& prepared) : prepared_(prepared) {}

double TechniquePilot::effort() const {
  if (!prepared_.config.chooses_techniques) return 0.0;
  return static_cast<double>(2 * SelectiveHeuristics::kSamplesOfGroup *
                             SelectiveHeuristics::kPilotPlaces) /
         static_cast<double>(prepared_.pixels());
}

std::uint64_t TechniquePilot::begin() {
  if (!prepared_.config.chooses_techniques) return 0;
  sampler_ = sampler_settings(prepared_.config.settings,
                              SelectivePreparation::omc_parameters(path_family_defaults("bdpt")));
  sampler_.heuristic = Heuristic::Balance;
  sampler_.shares_by_class = true;
  std::vector<ByTechniqueClass<double>> counts;
  for (const PathFamilyDefaults& offer : technique_offers()) {
    counts.push_back(relative_counts(offer));
  }
  found_.assign(kTrialItems, {TechniqueErrors(std::move(counts)), 0.0, {}});
  return kTrialItems;
}

void TechniquePilot::run(std::uint64_t item, Counters& counters) {
  PathSampler sampler(prepared_.scene(), sampler_);
  Found& found = found_[item];
  Sink sink(prepared_, found.errors);
  for (std::uint64_t place = 0; place < kTrialPlaces; ++place) {
    const std::uint64_t seed =
        hash_numbers(prepared_.config.settings.seed, RandomUse::TechniqueTrial, item, place);
    const std::uint64_t light_seed = hash_numbers(seed, RandomUse::TechniqueLight);
    const Vec2 raster =
        prepared_.view.raster(IndependentSource({seed, 0, light_seed, 0})
                                  .get_pair({Stream::Camera, 0, kEmissionDirection}));
    sink.begin_place(raster);
    // In a render camera paths of a pixel are well distributed, light paths are not.
    for (std::uint32_t i = 0; i < 2 * SelectiveHeuristics::kSamplesOfGroup; ++i) {
      SobolSource source({hash_numbers(seed, i % 2), i / 2, hash_numbers(light_seed, i), 0});
      found.errors.begin_sample();
      sampler.sample(source, raster, sink);
      found.errors.end_sample();
    }
    found.errors.end_place();
  }
  found.rays = static_cast<double>(sampler.rays());
  found.rays_by_use = sampler.rays_by_use();
  counters.add_rays(sampler.ray_counts());
}

void TechniquePilot::end() {
  if (found_.empty()) return;
  const std::vector<Found> found = std::move(found_);
  double rays = 0.0;
  RaysByUse by_use;
  for (const Found& one : found) {
    rays += one.rays;
    by_use += one.rays_by_use;
  }
  const std::vector<PathFamilyDefaults> offers = technique_offers();
  // Errors that are seen after equal time. Items stand for pixels: few of them have met what is
  // rare, and these do not decide alone.
  std::vector<double> errors;
  for (std::size_t i = 0; i < offers.size(); ++i) {
    TechniqueErrors::Spread own;
    for (const Found& one : found) {
      own.of_samples += one.errors.spread_of_own(i).of_samples;
      own.of_groups += one.errors.spread_of_own(i).of_groups;
    }
    const double left = own.of_samples > 0.0 ? std::min(1.0, own.of_groups / own.of_samples) : 1.0;
    double sum = 0.0;
    for (const Found& one : found) {
      sum += visible_error(std::max(0.0, one.errors.variance(i, left)));
    }
    errors.push_back(variance_of(sum / static_cast<double>(found.size())) *
                     rays_with(relative_counts(offers[i]), rays, by_use));
  }
  const double least = *std::min_element(errors.begin(), errors.end());
  if (!std::isfinite(least)) return;
  for (std::size_t i = 0; i < offers.size() && !chosen_; ++i) {
    if (errors[i] > SelectiveHeuristics::kClearlyFaster * least) continue;
    // Light that is there and that these samples have not met: they cannot judge.
    if (blind_spots_of(offers[i]) > blind_spots_of(offers.back())) return;
    chosen_ = offers[i];
  }
}

std::size_t TechniquePilot::blind_spots_of(const PathFamilyDefaults& offer) const {
  return prepared_.make_omc(offer, prepared_.config.settings)->findings().concerns.size();
}

}  // namespace ajar
