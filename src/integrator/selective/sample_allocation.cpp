#include "integrator/selective/sample_allocation.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/archive.h"
#include "image/visible_error.h"
#include "integrator/selective/heuristics.h"
#include "integrator/selective/optimal_thresholds.h"

namespace ajar {

std::uint64_t SampleAllocation::omc_samples(std::uint64_t samples) const {
  return prepared_.pilot_kept + samples;
}

double SampleAllocation::mutations(std::uint64_t samples) const {
  return before_ + rate() * static_cast<double>(samples - since_);
}

std::uint64_t SampleAllocation::steps(std::uint64_t sample, std::size_t chains,
                                      double share) const {
  const double scale = share * static_cast<double>(prepared_.pixels()) /
                       static_cast<double>(prepared_.config.settings.replicates) /
                       static_cast<double>(chains);
  const auto upto = [&](std::uint64_t samples) {
    return static_cast<std::uint64_t>(std::ceil(mutations(samples) * scale));
  };
  return std::max<std::uint64_t>(1, upto(sample + 1) - upto(sample));
}

void SampleAllocation::count_omc(std::uint64_t rays, std::uint64_t samples) {
  omc_rays_ += rays;
  omc_samples_ += samples;
}

void SampleAllocation::count_chains(std::uint64_t rays, std::uint64_t mutations) {
  chain_rays_ += rays;
  mutations_ += mutations;
}

void SampleAllocation::adjust(std::uint64_t samples, const WeightedErrors& of_omc,
                              const WeightedErrors& of_chains) {
  const double error = sum_of(trimmed(of_chains.variance));
  const double light = sum_of(of_chains.light);
  const double omc_error = sum_of(trimmed(of_omc.variance));
  const double pixels = static_cast<double>(prepared_.pixels());
  if (!(light > 0.0 && error > 0.0 && omc_error > 0.0)) return;
  correlation_ = error * mutations(samples) * pixels / (light * light);
  chain_error_ = error / (error + omc_error);
  const ThresholdCosts costs{
      static_cast<double>(omc_rays_) / static_cast<double>(omc_samples_) * pixels,
      static_cast<double>(chain_rays_) / static_cast<double>(mutations_), correlation_, 0.0};
  double best = 0.0;
  if (prepared_.config.objective == SelectiveConfig::Objective::Filtered) {
    const auto done = static_cast<double>(omc_samples(samples));
    const auto of_one_sample = [&](std::vector<double> variance) {
      for (double& of_pixel : variance) of_pixel *= done;
      return variance;
    };
    best = mutations_of_least_visible_error(
               of_one_sample(of_omc.variance), of_one_sample(of_chains.variance),
               mutations(samples) / done * pixels, costs.omc_sample, costs.mutation,
               SelectiveHeuristics::kFewestMutations * pixels, kMostMutations * pixels) /
           pixels;
  } else {
    best = best_mutations(omc_error * static_cast<double>(omc_samples(samples)), light, costs) /
           pixels;
  }
  // Sums that saturate may leave nothing to compare.
  if (!std::isfinite(best)) return;
  before_ = mutations(samples);
  adjusted_ = clamp_mutations(best);
  since_ = samples;
}

SampleAllocation::Known SampleAllocation::known() const {
  const double all = static_cast<double>(omc_rays_ + chain_rays_);
  Known known{.mutations_per_sample = rate(),
              .correlation = std::nullopt,
              .chain_rays = all > 0.0 ? static_cast<double>(chain_rays_) / all : 0.0,
              .chain_error = std::nullopt};
  if (correlation_ > 0.0) {
    known.correlation = correlation_;
    known.chain_error = chain_error_;
  }
  return known;
}

void SampleAllocation::set_counts(const std::array<std::uint64_t, 4>& counts) {
  omc_rays_ = counts[0];
  omc_samples_ = counts[1];
  chain_rays_ = counts[2];
  mutations_ = counts[3];
}

void SampleAllocation::save_state(OutputArchive& archive) const {
  archive(adjusted_, since_, before_, correlation_, chain_error_, counts());
}

void SampleAllocation::load_state(InputArchive& archive, std::uint64_t samples) {
  archive(adjusted_, since_, before_, correlation_, chain_error_, known_);
  const double most = std::max(prepared_.mutations, kMostMutations);
  // Where a sum over many epochs is rounded.
  constexpr double kRounding = 1.0 + 1e-6;
  const bool can_be = adjusted_ == 0.0 || adjusted_ == clamp_mutations(adjusted_);
  if (!can_be || since_ > samples || !(before_ >= 0.0) ||
      before_ > kRounding * most * static_cast<double>(since_) || !std::isfinite(correlation_) ||
      !std::isfinite(chain_error_)) {
    throw std::runtime_error("corrupt checkpoint: invalid sample allocation");
  }
  set_counts(known_);
}

void SampleAllocation::export_delta(OutputArchive& archive) {
  std::array<std::uint64_t, 4> delta = counts();
  for (std::size_t i = 0; i < delta.size(); ++i) delta[i] -= known_[i];
  set_counts(known_);
  archive(delta);
}

void SampleAllocation::import_delta(InputArchive& archive) {
  std::array<std::uint64_t, 4> delta{};
  archive(delta);
  for (std::size_t i = 0; i < delta.size(); ++i) known_[i] += delta[i];
  set_counts(known_);
}

}  // namespace ajar
