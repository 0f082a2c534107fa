#include "integrator/chain_survey.h"

#include <algorithm>
#include <numeric>

#include "core/random.h"

namespace ajar {

namespace {
constexpr double kMutationsPerShare = 5.5;
/// Of the light: with less, chains would not earn their bootstrap.
constexpr double kLeastShare = 0.002;
constexpr double kFewestMutations = 0.05;
constexpr double kMostMutations = 8.0;
}  // namespace

std::uint64_t ChainSurvey::begin() {
  if (!plan_.split) return 1;  // a black pilot: there is nothing to divide by
  RenderSettings settings = plan_.settings;
  settings.replicates = 1;
  settings.aovs.clear();
  settings.seed = hash_numbers(settings.seed, 0x5a7e1ULL);
  omc_ = plan_.make_omc(settings, {settings.min_depth, settings.max_depth}, &*plan_.split);
  film_ =
      std::make_unique<Film>(settings.resolution, settings.crop, Filter::box(), 1, omc_->layers());
  strong_.assign(omc_->items_in_pass(), 0.0);
  return strong_.size();
}

void ChainSurvey::run(std::uint64_t item, Counters& counters) {
  if (!omc_) return;
  Counters own;
  omc_->run_item(item, 0, 1, *film_, own);
  strong_[item] = own.strong_light;
  counters.rays += own.rays;
}

void ChainSurvey::end() {
  if (!omc_) return;
  const double strong = std::accumulate(strong_.begin(), strong_.end(), 0.0);
  const double share = strong / (plan_.brightness * static_cast<double>(plan_.pixels()));
  plan_.without_chains = share < kLeastShare;
  plan_.mutations = std::clamp(kMutationsPerShare * share, kFewestMutations, kMostMutations);
  film_.reset();
  omc_.reset();
}

}  // namespace ajar
