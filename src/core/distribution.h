#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/unit_interval.h"
#include "core/vector.h"

namespace ajar {

/// Piecewise-constant distribution over n cells of [0, 1), from finite weights ≥ 0 (all zero:
/// uniform). Every cell with a weight > 0 has a probability > 0: weights too small for the
/// resolution of uniform numbers are raised to 2⁻²² of the total. Choosing is monotone in u and
/// takes O(1) on average, O(log n) at worst: a binary search between guides. There are few guides,
/// so that they stay in the cache where the bounds do not fit. Source: Chen & Asau 1974, "On
/// generating random variates from an empirical distribution".
class Distribution1D {
 public:
  struct Choice {
    std::size_t index;
    float probability;  ///< selection probability of the cell; > 0
    float u;            ///< position within the cell, uniform in [0, 1) again
  };
  Distribution1D() = default;
  explicit Distribution1D(std::span<const float> weights);
  Choice choose(float u) const { return table().choose(u); }
  float probability(std::size_t index) const { return table().probability(index); }
  /// A number for which `choose` gives this cell, of probability > 0, and as nearly as floats allow
  /// position `u` within it. For uniform `u` it is uniform among all that do.
  float invert(std::size_t index, float u) const { return table().invert(index, u); }
  /// All of them.
  UnitInterval interval(std::size_t index) const {
    return {static_cast<double>(cdf_[index]), static_cast<double>(probability(index))};
  }
  std::size_t size() const { return cdf_.empty() ? 0 : cdf_.size() - 1; }
  /// Sum of the weights as given.
  double total() const { return total_; }

 private:
  friend class Distribution2D;
  static constexpr std::size_t kCellsPerGuide = 8;

  /// The tables of one distribution, wherever they are stored.
  struct Table {
    const float* cdf;  ///< size + 1 values from 0 to 1
    const std::uint32_t*
        guide;  ///< cell of k / guides for k = 0 … guides (the last one for k = guides)
    std::size_t guides;

    Choice choose(float u) const {
      u = std::min(u, kOneMinusEpsilon);
      // Exact in double precision, so the guides on both sides do enclose the cell of u.
      const auto k = static_cast<std::size_t>(static_cast<double>(u) * static_cast<double>(guides));
      // The last bound that is not beyond u starts the cell; a cell of zero width is never the one.
      std::size_t index = guide[k];
      std::size_t count = guide[k + 1] - index + 1;
      while (count > 1) {
        const std::size_t half = count / 2;
        index = cdf[index + half] <= u ? index + half : index;
        count -= half;
      }
      const float width = probability(index);
      return {index, width, std::min((u - cdf[index]) / width, kOneMinusEpsilon)};
    }
    float probability(std::size_t index) const { return cdf[index + 1] - cdf[index]; }
    float invert(std::size_t index, float u) const {
      // Bounds are compared as they are stored, so its own end is as far as it may go.
      const float number = cdf[index] + u * probability(index);
      return std::min(number, std::nextafter(cdf[index + 1], 0.F));
    }
  };
  static std::size_t guides_for(std::size_t cells) {
    return (cells + kCellsPerGuide - 1) / kCellsPerGuide;
  }
  /// Fills the tables of `weights` and returns their sum.
  static double fill(std::span<const float> weights, float* cdf, std::uint32_t* guide);
  Table table() const { return {cdf_.data(), guide_.data(), guides_for(size())}; }

  std::vector<float> cdf_;
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
  /// The numbers by which `sample` gives `uv`, where the density is > 0.
  Vec2 invert(const Vec2& uv) const;

 private:
  static float place(const Distribution1D::Choice& choice, int cells);
  Distribution1D::Table row(std::size_t y) const {
    return {cdfs_.data() + y * (static_cast<std::size_t>(width_) + 1),
            guides_.data() + y * (row_guides_ + 1), row_guides_};
  }

  int width_ = 0;
  int height_ = 0;
  std::size_t row_guides_ = 0;
  std::vector<float> cdfs_;  ///< row by row
  std::vector<std::uint32_t> guides_;
  Distribution1D marginal_;
};

}  // namespace ajar
