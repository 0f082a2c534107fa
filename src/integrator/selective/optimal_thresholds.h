#pragma once
#include <cstddef>
#include <span>
#include <vector>

/// Above which brightness the light of each region should be left to Markov chains, and how many
/// mutations they should make, so that the predicted error after a given time is smallest. The
/// counterpart of optimal_weights.h where light is divided path by path (`Division`): a higher
/// threshold leaves ordinary Monte Carlo (OMC) no brighter fireflies than it says, a lower weight
/// would only make them dimmer.
///
/// The model is that of optimal_weights.h with importance √w: after n samples per pixel and N
/// mutations the error is X/n + C·b²/N, where X sums the weighted variances of one OMC sample over
/// all pixels and b the light of the chains, times √w. If a sample of the whole picture costs c_s
/// and a mutation c_m, the best split of a time t leaves the error (√(X·c_s) + √(C·c_m)·b)² / t.
namespace ajar {

/// Variance and light of a region at each threshold; as many of both, the same for all regions. The
/// last one can be "none": no light for chains.
struct ThresholdEstimate {
  std::vector<double>
      variance;               ///< Σ w·V of what may go to chains, if it does beyond the threshold
  std::vector<double> light;  ///< Σ √w·I beyond it
};

struct ThresholdCosts {
  double omc_sample = 1.0;     ///< c_s: one sample of each pixel
  double mutation = 1.0;       ///< c_m
  double correlation = 1.0;    ///< C: variance of chains over that of as many independent samples
  double base_variance = 0.0;  ///< Σ w·V of what only OMC makes
};

struct ThresholdChoice {
  std::vector<std::size_t> chosen;  ///< number of the threshold of each region
  double variance = 0.0;            ///< X
  double chain_light = 0.0;         ///< b
  double error = 0.0;               ///< predicted error · time
};

/// A minimum of the error: no region could change its threshold alone and gain, found from each
/// threshold everywhere and taken from the best one. Of equal thresholds, the
/// lowest. Raises std::invalid_argument if the regions' numbers of thresholds differ, or for costs
/// that are not positive.
ThresholdChoice optimal_thresholds(std::span<const ThresholdEstimate> regions,
                                   const ThresholdCosts& costs);

/// The error of thresholds that are given.
ThresholdChoice predict_thresholds(std::span<const ThresholdEstimate> regions,
                                   const ThresholdCosts& costs, std::vector<std::size_t> chosen);

/// N/n of the best split of time: mutations per sample of the whole picture.
double best_mutations(double variance, double chain_light, const ThresholdCosts& costs);

}  // namespace ajar
