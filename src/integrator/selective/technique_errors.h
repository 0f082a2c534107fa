#pragma once
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

  /// Two samples follow, independent of each other.
  void begin_place();
  void begin_sample();
  /// A contribution: F (any unit), the class that found it, and the shares w_t of all classes.
  void add(double light, TechniqueClass found_by, const ByTechniqueClass<float>& shares);
  void end_sample();

  /// Mean over places of the variance of a sample; infinite for offers that cannot find what was
  /// found. Below 0 only by noise. NaN without samples.
  double variance(std::size_t offer) const;

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
    Sample now;
    Sample first;  ///< sample before, of the same place; nothing until it is over
  };
  std::vector<Offer> offers_;
  std::uint64_t samples_ = 0;
};

}  // namespace ajar
