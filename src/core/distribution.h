#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vector.h"

namespace ajar {

/// Piecewise-constant distribution over n cells of [0, 1), from finite weights ≥ 0 (all zero:
/// uniform). Every cell with a weight > 0 has a probability > 0: weights too small for the
/// resolution of uniform numbers are raised to 2⁻²² of the total. Choosing is monotone in u and
/// takes O(1) on average, O(log n) at worst: a binary search between guides. Source: Chen & Asau
/// 1974, "On generating random variates from an empirical distribution".
class Distribution1D {
 public:
  struct Choice {
    std::size_t index;
    float probability;  ///< of the cell; > 0
    float u;            ///< position within the cell, uniform in [0, 1) again
  };
  Distribution1D() = default;
  explicit Distribution1D(std::span<const float> weights);
  Choice choose(float u) const;
  float probability(std::size_t index) const;
  std::size_t size() const { return cdf_.empty() ? 0 : cdf_.size() - 1; }
  /// Sum of the weights as given.
  double total() const { return total_; }

 private:
  std::vector<float> cdf_;  ///< size() + 1 values from 0 to 1
  /// Cell of k / size() for k = 0 … size() (the last one for k = size()): where a search may start.
  std::vector<std::uint32_t> guide_;
  double total_ = 0.0;
};

/// Piecewise-constant distribution over the cells of a width × height grid that covers [0, 1)².
class Distribution2D {
 public:
  struct Sample {
    Vec2 uv;
    float pdf;  ///< with respect to area on the unit square
  };
  Distribution2D() = default;
  /// `weights` row by row, row 0 at v = 0.
  Distribution2D(std::span<const float> weights, int width, int height);
  /// `pdf(sample.uv)` is exactly `sample.pdf`.
  Sample sample(const Vec2& u) const;
  float pdf(const Vec2& uv) const;

 private:
  static float place(const Distribution1D::Choice& choice, int cells);

  int width_ = 0;
  int height_ = 0;
  std::vector<Distribution1D> rows_;
  Distribution1D marginal_;
};

}  // namespace ajar
