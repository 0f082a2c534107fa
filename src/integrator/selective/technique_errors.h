#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "transport/technique_set.h"

namespace ajar {

/// Variances that camera samples would have with other counts of technique classes, from samples
/// of all of them.
///
/// Under the balance heuristic the value F = f / Σ n_t p_t of a path does not depend on the
/// technique that found it. With counts n' it is F / r, r = Σ w_t n'_t / n_t, and it is found r
/// times as often; so F² / r adds up to the second moment with n', if contributions are
/// independent. Those of one camera path, and those of a light subpath that is connected to it, are
/// not: what they share is added from the sample's sums. Light paths that reach the lens are taken
/// for independent. Source: the proxies of Grittmann et al. 2022, "Efficiency-aware multiple
/// importance sampling"; the variance is ours.
class TechniqueErrors {
 public:
  /// `counts`: offer by offer, n'_t / n_t; 1 of implicit and explicit techniques.
  explicit TechniqueErrors(const std::vector<ByTechniqueClass<double>>& counts);

  /// Two groups of samples of one place follow, independent of each other, sample by sample in
  /// turns. Those of a group may be as well distributed as a pixel's are.
  void begin_place();
  void begin_sample();
  /// A contribution: F (any unit), the class that found it, and the shares w_t of all classes.
  void add(double light, TechniqueClass found_by, const ByTechniqueClass<float>& shares);
  void end_sample();
  void end_place();

  /// Mean over places of the variance of a sample; infinite for offers that cannot find what was
  /// found. Below 0 only by noise. NaN without samples. `left_of_own`: by well distributed points,
  /// of the variance of what camera paths bring alone.
  double variance(std::size_t offer, double left_of_own = 1.0) const;
  /// Variance of what camera paths bring alone, summed over places: of a sample, and that of a
  /// group's mean times its samples, which is less if they are well distributed.
  struct Spread {
    double of_samples = 0.0;
    double of_groups = 0.0;
  };
  const Spread& spread_of_own(std::size_t offer) const { return offers_[offer].spread; }

 private:
  /// Sums over a sample.
  struct Sample {
    double own = 0.0;    ///< light of the camera path alone
    double inner = 0.0;  ///< light by connections to its light subpath
    double own_squares = 0.0;
    double inner_squares = 0.0;
  };
  struct Offer {
    ByTechniqueClass<double> counts;
    double second_moment = 0.0;
    double mean_square = 0.0;  ///< product of a place's two samples
    double own_second_moment = 0.0;
    double own_mean_square = 0.0;
    Spread spread;
    Sample now;
    Sample before;                   ///< the sample before, of the other group
    std::array<double, 2> own_sums;  ///< own light of the place's groups
    double own_differences = 0.0;    ///< squares of those of its pairs of samples
  };
  std::vector<Offer> offers_;
  std::uint64_t samples_ = 0;
  std::uint64_t of_place_ = 0;  ///< samples of the place
};

}  // namespace ajar
