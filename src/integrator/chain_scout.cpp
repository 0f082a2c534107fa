#include "integrator/chain_scout.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "image/make_filter.h"
#include "integrator/chain_bootstrap.h"

namespace ajar {

std::uint64_t ChainScout::begin() {
  if (!plan_.splits) return 0;
  populations_ = make_populations(plan_);
  // As many for each replicate.
  const auto replicates = static_cast<std::uint64_t>(plan_.settings.replicates);
  const std::uint64_t in_round = plan_.pixels() * replicates;
  samples_ = (plan_.bootstrap + in_round - 1) / in_round * replicates;
  recruits_.expect_unknown(static_cast<double>(samples_));
  const RenderSettings settings = plan_.omc_settings();
  omc_ = plan_.make_omc(settings, plan_.omc_depths(), &*plan_.splits, &recruits_);
  film_ = std::make_unique<Film>(settings.resolution, settings.crop,
                                 make_filter(plan_.scene.film().filter), settings.replicates,
                                 omc_->layers());
  strong_light_.resize(omc_->items_in_pass());
  return strong_light_.size();
}

void ChainScout::run(std::uint64_t item, Counters& counters) {
  Counters own;
  omc_->run_item(item, 0, samples_, *film_, own);
  strong_light_[item] = own.strong_light;
  counters.rays += own.rays;
}

void ChainScout::end() {
  if (!plan_.splits) return;
  plan_.scouted = samples_ * plan_.pixels();
  plan_.pilot_kept = samples_;
  if (plan_.shares_effort) {
    // With a share r of the light for chains, r times so many mutations per camera sample are near
    // the least error at equal time, for what was measured of variances and costs.
    constexpr double kMutationsPerShare = 3.0;
    constexpr double kFewest = 0.25;
    const double strong = std::accumulate(strong_light_.begin(), strong_light_.end(), 0.0) /
                          static_cast<double>(plan_.scouted);
    const double share = std::min(1.0, strong / plan_.brightness);
    plan_.mutations = std::max(kMutationsPerShare * share, kFewest);
  }
  recruits_.join(populations_, 0, samples_);
  omc_.reset();
}

void ChainScout::hand_over(Film& film) {
  if (!film_) return;
  // What is left to chains is with the recruits.
  film.add_layers(*film_, std::array<std::string, 1>{"indirect"});
  film_.reset();
}

}  // namespace ajar
