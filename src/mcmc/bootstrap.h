#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "mcmc/moments.h"

/// Where chains start (Veach 1997, section 11.3.1): the arithmetic of seeds and of b. All functions
/// raise std::invalid_argument for weights that are not finite or are negative.
namespace ajar {

/// b, the mean of I over independent samples, and its standard error.
Moments bootstrap_moments(std::span<const double> weights);

/// Systematic resampling: `count` indices in ascending order, index i on average
/// count · weights[i] / Σ weights times, and never less or more often than that number rounded down
/// or up. `u` in [0, 1) is uniform. Empty if all weights are zero.
/// Source: Kitagawa 1996, "Monte Carlo filter and smoother".
std::vector<std::size_t> choose_seeds(std::span<const double> weights, std::size_t count, double u);

/// Selection of bootstrap samples as seeds.
enum class SeedFilter {
  None,      ///< in proportion to I
  Weighted,  ///< outliers less often, with larger weights instead
  Dropped    ///< outliers never: biased
};

/// Weights for the selection of seeds. Outliers are samples whose I lies more than `spread`
/// standard deviations above the mean; a chain that starts from one of them and moves little burns
/// a spot into the picture. With `Weighted` they count as if they lay at that limit; with
/// `Dropped`, 0, unless nothing else is left. As we read He 2018, "variance-filtered seeds".
std::vector<double> filter_weights(std::span<const double> weights, SeedFilter filter,
                                   double spread);
/// Weight of a chain that starts from sample `index`, relative to the weight it would have without
/// a filter: (I / Σ I) / (filtered / Σ filtered), which keeps the expected light of its start. 1
/// for `Dropped`, which is biased.
double seed_weight(std::span<const double> weights, std::span<const double> filtered,
                   SeedFilter filter, std::size_t index);

/// Shares `count` chains among path depths in proportion to their b, by largest remainders (ties go
/// to the shorter paths). A depth with b > 0 gets at least one chain, or its light would be
/// missing; so if there are more such depths than `count`, each gets one and the total is their
/// number. Otherwise the total is `count`. All zero if every b is zero.
std::vector<std::size_t> apportion(std::span<const double> b, std::size_t count);

}  // namespace ajar
