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

/// Of the picture that is rendered with each offer.
double share_of_picture(const ChainPlan& plan) {
  const auto pixels = static_cast<double>(plan.pixels());
  const double rendered =
      std::clamp(pixels / SelectiveHeuristics::kOnePixelOf, SelectiveHeuristics::kFewestTrialPixels,
                 SelectiveHeuristics::kMostTrialPixels);
  return std::min(1.0, rendered / pixels);
}

}  // namespace

/// Ordinary Monte Carlo with one of the offers.
class TechniquePilot::Candidate final : public StrongPathSinks {
 public:
  /// `plan` has the techniques of the offer.
  Candidate(const ChainPlan& plan, const RenderSettings& settings)
      : plan_(plan),
        divisions_(Division(plan.brightness, plan.view.importance)),
        omc_(
            plan.make_omc(settings, plan.omc_depths(), {.divisions = &divisions_, .strong = this})),
        film_(settings.resolution, settings.crop, Filter::box(), kReplicates, omc_->layers()) {}

  std::uint64_t tiles() const { return omc_->items_in_round(); }

  void render(std::uint64_t tile, Counters& counters) {
    Counters own;
    omc_->run_item(tile, 0, kReplicates, film_, own);
    rays_ += own.rays;
    counters.add_rays(own);
  }

  std::unique_ptr<StrongPathSink> make(Film& /*film*/, Counters& /*counters*/) const override {
    return std::make_unique<Sink>(*this);
  }

  Errors errors() const {
    const WeightedErrors of_pixels =
        weighted_errors(develop_layers(film_, *omc_, kReplicates, {"direct", kWeakLayer}),
                        plan_.settings.crop, plan_.view.importance);
    const double unit = plan_.brightness * plan_.brightness / kUnit / kReplicates;
    return {sum_of(trimmed(of_pixels.variance)) * kReplicates,
            static_cast<double>(strong_.load()) * unit,
            static_cast<double>(from_light_.load()) * unit,
            static_cast<double>(inner_.load()) * unit, static_cast<double>(rays_.load())};
  }

 private:
  /// Of sums of squares, which as whole numbers do not depend on the order of threads.
  static constexpr double kUnit = 1 << 20;

  class Sink final : public StrongPathSink {
   public:
    explicit Sink(const Candidate& candidate) : candidate_(candidate) {}
    bool spread(SampleSource& /*numbers*/, StrongPath& path) override {
      const double light = std::abs(path.energy) / candidate_.plan_.brightness;
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

  const ChainPlan& plan_;
  Divisions divisions_;
  std::unique_ptr<Integrator> omc_;
  Film film_;
  std::atomic<std::uint64_t> rays_{0};
  mutable std::atomic<std::uint64_t> strong_{0};
  mutable std::atomic<std::uint64_t> from_light_{0};
  mutable std::atomic<std::uint64_t> inner_{0};
};

TechniquePilot::TechniquePilot(ChainPlan& plan, PathFamilyDefaults offer,
                               std::shared_ptr<Findings> findings)
    : plan_(plan), offer_(std::move(offer)), findings_(std::move(findings)) {}
TechniquePilot::~TechniquePilot() = default;

std::vector<std::unique_ptr<TechniquePilot>> TechniquePilot::make_all(ChainPlan& plan) {
  const auto findings = std::make_shared<Findings>();
  std::vector<std::unique_ptr<TechniquePilot>> stages;
  for (PathFamilyDefaults& offer : offers()) {
    stages.push_back(
        std::unique_ptr<TechniquePilot>(new TechniquePilot(plan, std::move(offer), findings)));
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
  if (!plan_.chooses_omc) return 0.0;
  return kReplicates * ChainPlan::effort_with(offer_.light_paths_per_pixel) *
         share_of_picture(plan_);
}

std::uint64_t TechniquePilot::begin() {
  if (!plan_.chooses_omc || !(plan_.brightness > 0.0) || findings_->decided) return 0;
  RenderSettings settings = plan_.settings;
  settings.replicates = kReplicates;
  settings.aovs.clear();
  settings.seed = hash_numbers(settings.seed, RandomUse::TechniqueTrial);
  const PathFamilyDefaults before = plan_.omc;
  plan_.set_omc(offer_);
  candidate_ = std::make_unique<Candidate>(plan_, settings);
  plan_.set_omc(before);
  const std::uint64_t all = candidate_->tiles();
  const auto count =
      static_cast<std::uint64_t>(std::ceil(static_cast<double>(all) * share_of_picture(plan_)));
  for (std::uint64_t i = 0; i < count; ++i) {
    // One of each stretch, so that they lie all over the picture.
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
  findings_->of_offers.push_back(candidate_->errors());
  candidate_.reset();
  choose();
}

void TechniquePilot::choose() const {
  const std::vector<Errors>& found = findings_->of_offers;
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
  findings_->decided = found.size() == offers().size() || (best < kUsual && !for_chains);
  if (findings_->decided) plan_.set_omc(offers()[best]);
}

}  // namespace ajar
