#include "integrator/selective/chain_trial.h"

#include <algorithm>
#include <numeric>

#include "core/random.h"
#include "core/random_use.h"
#include "integrator/metropolis/chain_film_sink.h"
#include "integrator/selective/chain_bootstrap.h"
#include "integrator/selective/heuristics.h"
#include "integrator/selective/weighted_errors.h"
#include "mcmc/primary/primary_runner.h"

namespace ajar {

namespace {

/// Of each half: few are enough, since the errors of all pixels are added up.
constexpr int kPictures = 4;

/// The part of b that each of its chains makes.
double share_of_chain(const ChainPopulation& population) {
  return population.b(0.0) / static_cast<double>(population.chains.size());
}

}  // namespace

double ChainTrial::effort() const {
  if (recruits_ == nullptr || !plan_.chooses_thresholds() || !pilot_.stays()) return 0.0;
  return SelectiveHeuristics::kTrialMutations * SelectiveHeuristics::kEffortOfOnePath;
}

std::uint64_t ChainTrial::begin() {
  // Of a pilot that does not stay, all that it found for chains seeds those of the whole render,
  // and must decide nothing about them.
  if (recruits_ == nullptr || !plan_.chooses_thresholds()) return 0;
  if (!pilot_.has_rendered() || !pilot_.stays()) return 0;
  // What a half decides for itself, its own samples must not have a part in.
  std::vector<std::size_t> halves;
  for (std::size_t h = 0; h < pilot_.halves(); ++h) {
    if (pilot_.chains_may_pay(h)) halves.push_back(h);
  }
  if (halves.empty()) return 0;
  populations_ = make_populations(plan_);
  recruits_->join_for_trial(populations_, 0, pilot_.samples());
  list_items(halves);
  // A wide filter would only spread what chains leave over blotches.
  film_ = std::make_unique<Film>(
      plan_.settings.resolution, plan_.settings.crop, Filter::box(),
      kPictures * static_cast<int>(pilot_.halves()),
      std::vector<LayerSpec>{{.name = "indirect", .magnitude = plan_.brightness}});
  return items_.size();
}

void ChainTrial::list_items(const std::vector<std::size_t>& halves) {
  halves_.resize(pilot_.halves());
  light_.resize(halves_.size() * kPictures);
  for (const std::size_t h : halves) {
    const std::vector<int> seen = pilot_.seen_by(h);
    for (std::size_t p = 0; p < populations_.size(); ++p) {
      if (std::find(seen.begin(), seen.end(), populations_[p].replicate) == seen.end()) continue;
      for (std::size_t c = 0; c < populations_[p].chains.size(); ++c) {
        const std::uint64_t lot = hash_numbers(populations_[p].seed, RandomUse::ChainTrial, c);
        constexpr std::uint64_t kOneOf = SelectiveHeuristics::kOneChainOf;
        if (lot % kOneOf != 0) continue;
        const std::size_t picture = h * kPictures + lot / kOneOf % kPictures;
        items_.push_back({p, c, h, picture});
        ++halves_[h].chains;
        light_[picture] += share_of_chain(populations_[p]);
      }
    }
  }
}

void ChainTrial::run(std::uint64_t item, Counters& counters) {
  const Item& own = items_[item];
  ChainPopulation& population = populations_[own.population];
  MemberChain& member = population.chains[own.chain];
  Half& half = halves_[own.half];
  const PathGroup& group = plan_.groups[population.group];
  const auto target = plan_.make_target(group, population.replicate);
  PrimaryRunner runner(plan_.moves.settings, *plan_.moves.mutation, group.shape, *target);
  Counters discarded;
  ChainFilmSink sink(*film_, static_cast<int>(own.picture), plan_.view.importance, target.get(),
                     discarded);
  const double mutations = SelectiveHeuristics::kTrialMutations *
                           static_cast<double>(plan_.pixels()) /
                           static_cast<double>(halves_.size());
  const auto steps =
      static_cast<std::uint64_t>(std::max(1.0, mutations / static_cast<double>(half.chains)));
  sink.begin(
      member.weight * share_of_chain(population) * plan_.view.area() / static_cast<double>(steps),
      nullptr);
  runner.run(member.chain, steps, sink);
  half.mutations += steps;
  half.rays += target->rays();
  counters.add_rays(target->ray_counts());
}

ChainCosts ChainTrial::costs_of(std::size_t h) const {
  const Half& half = halves_[h];
  if (half.mutations == 0) return {};
  const auto first = light_.begin() + static_cast<std::ptrdiff_t>(h * kPictures);
  const double light = std::accumulate(first, first + kPictures, 0.0);
  Replicates pictures;
  for (std::size_t i = 0; i < kPictures; ++i) {
    const std::size_t picture = h * kPictures + i;
    // Without chains it would tell nothing.
    if (light_[picture] == 0.0) return {};
    pictures.push_back(
        film_->develop_replicate(0, static_cast<int>(picture), light / light_[picture]));
  }
  const WeightedErrors errors =
      weighted_errors(pictures, plan_.settings.crop, plan_.view.importance);
  const double all = sum_of(errors.light);
  const auto mutations = static_cast<double>(half.mutations);
  const double correlation = sum_of(trimmed(errors.variance)) * mutations / (all * all);
  if (!(correlation > 0.0)) return {};
  return {SelectiveHeuristics::kBeyondTrial * correlation,
          static_cast<double>(half.rays) / mutations};
}

void ChainTrial::end() {
  if (!pilot_.has_rendered()) return;
  std::vector<ChainCosts> costs(pilot_.halves());  // typical where there was no trial
  for (std::size_t h = 0; h < halves_.size(); ++h) costs[h] = costs_of(h);
  pilot_.decide(costs);
  populations_.clear();
  film_.reset();
}

}  // namespace ajar
