#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "transport/technique_set.h"

namespace ajar {

/// Light and variance of single techniques in a render. Summable. Techniques of longer subpaths
/// than `kMaxVertices` are kept together as (s, t) = (kMaxVertices + 1, kMaxVertices + 1).
class TechniqueShares {
 public:
  static constexpr int kMaxVertices = 16;
  struct Share {
    Technique technique;
    double light;     ///< share of the picture's light, between 0 and 1
    double variance;  ///< share of the sum of the techniques' variances; correlations not counted
  };

  /// `light`: sum of luminances; `variance`: sum over pixels of the variance of one sample, times
  /// the number of samples.
  void add(std::size_t slot, double light, double variance);
  TechniqueShares& operator+=(const TechniqueShares& other);
  /// Everything there is, for checkpoints and other machines: light and variance of each slot, or
  /// nothing at all; and adding that.
  std::vector<double> sums() const;
  void add_sums(std::span<const double> sums);
  /// Sorted by s, then t; techniques without a contribution are left out.
  std::vector<Share> list() const;

  static std::size_t slot(Technique technique);
  static constexpr std::size_t kSlots = (kMaxVertices + 2) * (kMaxVertices + 2);

 private:
  struct Sums {
    double light = 0.0;
    double variance = 0.0;
  };
  std::vector<Sums> sums_;  // empty until something is added
};

}  // namespace ajar
