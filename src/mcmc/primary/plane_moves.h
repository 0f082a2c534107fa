#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/vector.h"
#include "mcmc/primary/mutation.h"
#include "mcmc/primary/raster_grid.h"

namespace ajar {

/// Dependence of small steps on the image plane (docs/methods/mutations.md), with the constants of
/// He et al. 2020.
struct PlaneRule {
  bool adaptive = false;    ///< step sizes follow the evenness of the visits
  bool neighbours = false;  ///< densely visited pixels are left for a neighbour
  /// Published rules: the distribution of the chain is not that of its target. Otherwise steps are
  /// accepted with the ratio of their densities there and back.
  bool published = false;
  double adaptive_visits = 50.0;    ///< M1: a pixel with fewer visits keeps the step size
  double uneven = 50.0;             ///< k1: from this variance of visits on, steps are shorter
  double even = 10.0;               ///< k2: up to this variance, steps are longer
  double shorten = 23.0;            ///< λ1: by λ1 / variance
  double lengthen = 0.7;            ///< λ2: by λ2 · variance
  double neighbour_visits = 100.0;  ///< W: a pixel with fewer visits is not dense

  bool active() const { return adaptive || neighbours; }
  /// Visits per pixel from which on there is anything to do in a pixel that has as many as others.
  double visits_needed() const;
};

/// Statistics of a pixel: visits by chains, and their light.
struct PixelVisits {
  float visits = 0.F;
  float light = 0.F;
};

/// Small steps of the two raster numbers that depend on where on the image a state is. Maps are
/// those given here, and do not change. Stateless; shared by all threads.
///
/// `adaptive`: in a pixel with M1 visits or more, steps are multiplied by a factor h that follows
/// from the variance of the visits of the pixel and its eight neighbours: λ1/variance ≤ 1 if that
/// is above k1, λ2·variance ≥ 1 if it is below k2.
///
/// `neighbours`: from a pixel with W visits or more, a step leads to one of its eight neighbours,
/// any place in it equally likely. Neighbour i has weight exp(l_i/Σl − q_i/Σq), l being the light
/// and q the visits, the sums over all nine.
///
/// Exact: neighbours are chosen in proportion to their weight, and `log_ratio` compares both ways.
/// Published: the neighbour of largest weight is taken, nothing is compared, and the factor is not
/// applied here: it is kept from one large step to the next (`ChainSource`).
class PlaneMoves {
 public:
  /// `pixels` row by row. `scales` multiplies the steps of the two numbers; `mutation` must outlive
  /// this. Neighbours are used only if the image has at least three rows and columns.
  PlaneMoves(const RasterGrid& grid, const PlaneRule& rule, std::span<const PixelVisits> pixels,
             const Mutation& mutation, const std::array<float, 2>& scales = {1.F, 1.F});

  bool published() const { return rule_.published; }
  /// h of the pixel of a state: within [1/64, 64].
  float factor(const Vec2& at) const { return factors_[grid_.index(grid_.pixel(at))]; }
  bool dense(const Vec2& at) const { return dense(grid_.pixel(at)); }

  /// Where a small step leads; empty if it is an ordinary step of the mutation. `key` names the
  /// randomness.
  std::optional<Vec2> move(const Vec2& from, std::uint64_t key) const;
  /// Density of a small step, with respect to area of the unit square, ordinary ones included. For
  /// exact rules only.
  double density(const Vec2& from, const Vec2& to) const;
  /// log density(to → from) − log density(from → to); 0 if published.
  double log_ratio(const Vec2& from, const Vec2& to) const;

 private:
  static constexpr std::size_t kNeighbours = 8;

  bool dense(const Vec2i& pixel) const;
  bool ordinary(const Vec2& at) const { return !dense(at) && factor(at) == 1.F; }
  std::array<double, kNeighbours> weights(const Vec2i& pixel) const;
  std::array<float, 2> scaled(float factor) const;

  RasterGrid grid_;
  PlaneRule rule_;
  std::vector<PixelVisits> pixels_;
  std::vector<float> factors_;
  const Mutation& mutation_;
  std::array<float, 2> scales_;
};

}  // namespace ajar
