#include "integrator/chain_scout.h"

#include <algorithm>
#include <numeric>

#include "core/random.h"
#include "integrator/chain_bootstrap.h"

namespace ajar {

std::uint64_t ChainScout::begin() {
  if (!plan_.splits) return 0;
  populations_ = make_populations(plan_);
  samples_ = (plan_.bootstrap + plan_.pixels() - 1) / plan_.pixels();
  recruits_.expect_unknown(static_cast<double>(samples_));
  RenderSettings settings = plan_.settings;
  settings.replicates = 1;
  settings.aovs.clear();
  settings.seed = hash_numbers(settings.seed, 0x5c007ULL);
  omc_ = plan_.make_omc(settings, {settings.min_depth, settings.max_depth}, &*plan_.splits,
                        &recruits_);
  film_ =
      std::make_unique<Film>(settings.resolution, settings.crop, Filter::box(), 1, omc_->layers());
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
  if (!plan_.splits) {
    if (plan_.omc_samples == 0.0) plan_.omc_samples = 1.0;
    return;
  }
  const double samples = static_cast<double>(samples_ * plan_.pixels());
  recruits_.join_scattered(populations_, samples);
  plan_.scouted = samples_ * plan_.pixels();
  film_.reset();
  omc_.reset();
  if (plan_.omc_samples > 0.0) return;
  // With a share r of the light for chains, r times so many mutations per camera sample are near
  // the least error at equal time, for what was measured of variances and costs.
  constexpr double kMutationsPerShare = 3.0;
  constexpr double kMostSamples = 4.0;
  const double strong = std::accumulate(strong_light_.begin(), strong_light_.end(), 0.0) / samples;
  const double share = std::min(1.0, strong / plan_.brightness);
  plan_.omc_samples = 1.0 / std::max(kMutationsPerShare * share, 1.0 / kMostSamples);
}

}  // namespace ajar
