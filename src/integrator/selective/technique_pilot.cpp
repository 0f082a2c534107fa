#include "integrator/selective/technique_pilot.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <utility>

#include "core/random.h"
#include "core/random_use.h"
#include "integrator/montecarlo/path_family.h"
#include "integrator/selective/heuristics.h"
#include "integrator/selective/weighted_errors.h"

namespace ajar {

namespace {

/// The first makes do with few light subpaths; then in order of how many there are.
std::vector<PathFamilyDefaults> offers() {
  const PathFamilyDefaults usual = path_family_defaults("bdpt");
  return {path_family_defaults("ibpt"),
          usual,
          {usual.techniques, SelectiveHeuristics::kManyLightSubpaths, usual.roulette_start}};
}
constexpr std::size_t kUsual = 1;
/// One sample per pixel of the tiles in each of them.
constexpr int kReplicates = 4;

/// Share of the picture that is rendered with each offer.
double share_of_picture(const SelectiveConfig& config) {
  return std::min(1.0, SelectiveHeuristics::kTrialPixels / static_cast<double>(config.pixels()));
}

}  // namespace

/// Ordinary Monte Carlo with one of the offers.
class TechniquePilot::Candidate final : public OutlierSinkFactory {
 public:
  Candidate(const SelectivePreparation& prepared, const PathFamilyDefaults& offer,
            const RenderSettings& settings)
      : prepared_(prepared),
        divisions_(Division(prepared.brightness, prepared.view.importance)),
        omc_(prepared.make_omc(offer, settings, {.divisions = &divisions_, .strong = this})),
        film_(settings.resolution, settings.crop, Filter::box(), kReplicates, omc_->layers()) {}

  std::uint64_t tiles() const { return omc_->items_in_round(); }

  void render(std::uint64_t tile, Counters& counters) {
    Counters own;
    omc_->run_item(tile, 0, kReplicates, film_, own);
    rays_ += own.rays;
    counters.add_rays(own);
  }

  std::unique_ptr<OutlierSink> make(Film& /*film*/, Counters& /*counters*/) const override {
    return std::make_unique<Sink>(*this);
  }

  Errors errors() const {
    const WeightedErrors of_pixels =
        weighted_errors(develop_layers(film_, *omc_, kReplicates, {"direct", kWeakLayer}),
                        prepared_.config.settings.crop, prepared_.view.importance);
    const double unit = prepared_.brightness * prepared_.brightness / kUnit / kReplicates;
    return {sum_of(trimmed(of_pixels.variance)) * kReplicates,
            static_cast<double>(strong_.load()) * unit,
            static_cast<double>(from_light_.load()) * unit,
            static_cast<double>(inner_.load()) * unit, static_cast<double>(rays_.load())};
  }

 private:
  /// Unit of sums of squares, which as whole numbers do not depend on the order of threads.
  static constexpr double kUnit = 1 << 20;

  class Sink final : public OutlierSink {
   public:
    explicit Sink(const Candidate& candidate) : candidate_(candidate) {}
    bool spread(SampleSource& /*numbers*/, OutlierPath& path) override {
      const double light = std::abs(path.energy) / candidate_.prepared_.brightness;
      candidate_.strong_ += square(std::min(light, SelectiveHeuristics::kBright));
      if (path.technique.s < 2) return true;
      const std::uint64_t find = square(std::min(light, SelectiveHeuristics::kHighestThreshold));
      candidate_.from_light_ += find;
      if (path.technique.t >= 2) candidate_.inner_ += find;
      return true;
    }

   private:
    static std::uint64_t square(double light) {
      return static_cast<std::uint64_t>(light * light * kUnit);
    }
    const Candidate& candidate_;
  };

  const SelectivePreparation& prepared_;
  Divisions divisions_;
  std::unique_ptr<Integrator> omc_;
  Film film_;
  std::atomic<std::uint64_t> rays_{0};
  mutable std::atomic<std::uint64_t> strong_{0};
  mutable std::atomic<std::uint64_t> from_light_{0};
  mutable std::atomic<std::uint64_t> inner_{0};
};

TechniquePilot::TechniquePilot(const SelectivePreparation& prepared, PathFamilyDefaults offer,
                               std::shared_ptr<Trials> trials)
    : prepared_(prepared), offer_(std::move(offer)), trials_(std::move(trials)) {}
TechniquePilot::~TechniquePilot() = default;

std::vector<std::unique_ptr<TechniquePilot>> TechniquePilot::make_all(
    const SelectivePreparation& prepared) {
  const auto trials = std::make_shared<Trials>();
  std::vector<std::unique_ptr<TechniquePilot>> stages;
  for (PathFamilyDefaults& offer : offers()) {
    stages.push_back(
        std::unique_ptr<TechniquePilot>(new TechniquePilot(prepared, std::move(offer), trials)));
  }
  return stages;
}

bool TechniquePilot::is_for_chains(const std::vector<Errors>& found) {
  const Errors& few = found.front();
  const Errors& usual = found[kUsual];
  return usual.strong > SelectiveHeuristics::kMuchStrong * usual.weak &&
         usual.strong > SelectiveHeuristics::kNoRarer * few.strong;
}

double TechniquePilot::effort() const {
  if (!prepared_.config.chooses_techniques) return 0.0;
  return kReplicates * effort_with(offer_.light_paths_per_pixel) *
         share_of_picture(prepared_.config);
}

std::uint64_t TechniquePilot::begin() {
  if (!prepared_.config.chooses_techniques || trials_->chosen) return 0;
  RenderSettings settings = prepared_.config.settings;
  settings.replicates = kReplicates;
  settings.aovs.clear();
  settings.seed = hash_numbers(settings.seed, RandomUse::TechniqueTrial);
  candidate_ = std::make_unique<Candidate>(prepared_, offer_, settings);
  const std::uint64_t all = candidate_->tiles();
  const auto count = static_cast<std::uint64_t>(
      std::ceil(static_cast<double>(all) * share_of_picture(prepared_.config)));
  for (std::uint64_t i = 0; i < count; ++i) {
    // One tile of each of `count` equal ranges, so that they lie all over the picture.
    const std::uint64_t first = i * all / count;
    const std::uint64_t last = (i + 1) * all / count;
    tiles_.push_back(first +
                     hash_numbers(settings.seed, RandomUse::TechniqueTiles, i) % (last - first));
  }
  return tiles_.size();
}

void TechniquePilot::run(std::uint64_t item, Counters& counters) {
  candidate_->render(tiles_[item], counters);
}

void TechniquePilot::end() {
  if (!candidate_) return;
  trials_->errors.push_back(candidate_->errors());
  candidate_.reset();
  choose();
}

void TechniquePilot::choose() const {
  const std::vector<Errors>& found = trials_->errors;
  // Tiles without light tell nothing.
  if (found.size() <= kUsual || !(found[kUsual].after_equal_time() > 0.0)) return;
  const bool for_chains = is_for_chains(found);
  const bool needs_usual =
      found[kUsual].from_light > SelectiveHeuristics::kMuchFromLight * found[kUsual].weak ||
      (for_chains && std::any_of(found.begin() + kUsual, found.end(), [](const Errors& of) {
         return of.inner > SelectiveHeuristics::kAnyInner * of.weak;
       }));
  std::size_t best = needs_usual ? kUsual : 0;
  for (std::size_t i = best + 1; i < found.size(); ++i) {
    if (found[i].after_equal_time() < found[best].after_equal_time()) best = i;
  }
  // One light subpath per sample may have found nothing by chance.
  if (found.size() == offers().size() || (best < kUsual && !for_chains)) {
    trials_->chosen = offers()[best];
  }
}

}  // namespace ajar
