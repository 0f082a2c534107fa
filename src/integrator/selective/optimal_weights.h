#pragma once
#include <span>
#include <vector>

/// How much of each region's light Markov chains should render, and for how long, so that the
/// predicted error of the sum of both halves is smallest (docs/methods/selective.md).
///
/// The model. Ordinary Monte Carlo (OMC) of n samples per pixel renders the share 1 − σ of the
/// light I_j of pixel j; N mutations render σ·I_j with target I·σ·q, where q is an importance map
/// that is divided out again. The error weighs the variance of a pixel with w_j (1 for absolute,
/// 1/(I² + δ) for relative error). Then it is
///
///     Σ_j w_j (1 − σ_j)² V_j / n  +  C/N · (Σ_j I_j σ_j q_j) (Σ_j w_j I_j σ_j / q_j).
///
/// By Cauchy and Schwarz q = √w is best, and makes the second term C/N · b², b = Σ_j √w_j I_j σ_j.
/// It is what these functions assume: if the error is weighted, the chains are to run with the
/// importance map √w. (With q = 1 and w ≠ 1 the chains' error is larger than predicted.)
namespace ajar {

/// What is known of a region, and what is allowed there.
struct RegionEstimate {
  /// Σ_j w_j V_j over its pixels, V_j the variance of one OMC sample. May be infinite: the region
  /// then takes as much of the chains as it may.
  double variance = 0.0;
  double light = 0.0;    ///< Σ_j √w_j I_j over its pixels
  double minimum = 0.0;  ///< bounds of σ in [0, 1]: a floor ε, or what the user has set
  double maximum = 1.0;
};

struct Effort {
  double omc_samples = 1.0;  ///< n, per pixel; above 0
  double mutations = 1.0;    ///< N, in the whole picture; above 0
  double correlation = 1.0;  ///< C ≥ 0: variance of chains over that of as many independent samples
};

/// What the weights are a minimum of.
enum class WeightRule {
  /// Of the error of the picture.
  Picture,
  /// Of the error of each pixel, with b held where it is. But b grows with each
  /// σ: a pixel given to the chains makes all others noisier. Leaving that out gives chains up to
  /// twice as much as they should have.
  Pixel
};

struct OptimalWeights {
  std::vector<double> weights;  ///< σ of each region
  double chain_light = 0.0;     ///< b
  double omc_error = 0.0;       ///< predicted, of the picture: sums over pixels
  double chain_error = 0.0;
  double error() const { return omc_error + chain_error; }
};

/// The solution of σ = clip(1 − C·g·b·n/(N·V), minimum, maximum) with b = Σ g·σ, g the light and V
/// the variance of a region (with 2N for `WeightRule::Pixel`), by bisection of b: the right side
/// falls as b grows, so there is exactly one. A region without variance gets its minimum. For
/// `WeightRule::Picture` it is the minimum of the error, which is convex in σ. Raises
/// std::invalid_argument for what is negative, not a number or out of its range.
OptimalWeights optimal_weights(std::span<const RegionEstimate> regions, const Effort& effort,
                               WeightRule rule = WeightRule::Picture);

/// The errors predicted for any weights, one per region.
OptimalWeights predict_error(std::span<const RegionEstimate> regions, const Effort& effort,
                             std::span<const double> weights);

/// What time buys.
struct RenderCosts {
  double seconds = 0.0;                 ///< to be divided; above 0
  double seconds_per_omc_sample = 0.0;  ///< per sample per pixel, i.e. of a whole picture; above 0
  double seconds_per_mutation = 0.0;    ///< above 0
  double correlation = 1.0;             ///< C
  /// Σ_j w_j times the variance of what only OMC renders (direct light), per sample per pixel.
  double omc_only_variance = 0.0;
};

struct TimeSplit {
  double omc_share = 1.0;  ///< of the time, strictly between 0 and 1
  Effort effort;           ///< what that buys
  OptimalWeights weights;  ///< for that effort; `omc_error` includes what only OMC renders
};

/// The split of time that makes the predicted error smallest, with the weights that belong to it.
/// The error is X/f + Y/(1 − f) for a share f of OMC; it is convex in σ and f together, so its
/// minimum over σ is convex in f, and the sign of the derivative, Y/(1 − f)² − X/f², leads there.
/// If nothing has any error, OMC gets (almost) all the time. Raises std::invalid_argument as above.
TimeSplit optimal_split(std::span<const RegionEstimate> regions, const RenderCosts& costs);

}  // namespace ajar
