#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "mcmc/primary/gaussian_mutation.h"
#include "mcmc/primary/plane_moves.h"

/// A target on the image plane whose chains can be followed exactly: pixels are points, so that the
/// distribution of a chain is a vector and a step a matrix.
namespace ajar::testing {

/// Two rooms side by side, 5 × 6 pixels each, and dim walls between them (the sides of the image
/// are joined). Chains have visited the left room evenly and the right one unevenly: as `adaptive`
/// sees it, steps are to be longer in the left room and shorter in the right one.
struct TwoRooms {
  static constexpr int kColumns = 12;
  static constexpr int kRows = 6;
  static constexpr std::size_t kPixels = std::size_t{kColumns} * kRows;

  TwoRooms() : target(kPixels), pixels(kPixels) {
    for (int y = 0; y < kRows; ++y) {
      for (int x = 0; x < kColumns; ++x) {
        const std::size_t i = grid.index({x, y});
        const bool odd = (x + y) % 2 != 0;
        if (wall(x)) {
          target[i] = 0.1;
          pixels[i] = {20.F, 4.F};
        } else if (left(x)) {
          target[i] = 1.0;
          pixels[i] = {odd ? 62.F : 58.F, odd ? 41.F : 39.F};
        } else {
          target[i] = odd ? 1.25 : 0.75;
          pixels[i] = {odd ? 70.F : 54.F, odd ? 64.F : 30.F};
        }
        sum += target[i];
      }
    }
  }
  static bool wall(int x) { return x % 6 == 0; }
  static bool left(int x) { return x < 6; }
  PlaneMoves moves(const PlaneRule& rule) const { return {grid, rule, pixels, mutation}; }
  static Vec2 center(std::size_t pixel) {
    const std::size_t x = pixel % kColumns;
    const std::size_t y = pixel / kColumns;
    return {(static_cast<float>(x) + 0.5F) / kColumns, (static_cast<float>(y) + 0.5F) / kRows};
  }

  RasterGrid grid{{0.F, 0.F}, {kColumns, kRows}, {kColumns, kRows}};
  GaussianMutation mutation{0.08};
  std::vector<double> target;  ///< I of each pixel
  double sum = 0.0;
  std::vector<PixelVisits> pixels;
};

/// Deviation of a distribution of pixels from the target's.
struct PlaneBias {
  double left_half;  ///< relative error of the left half's share
  double pixel;      ///< largest relative error of a pixel
};

/// The stationary distribution of chains that make large steps with probability `large`. The
/// published factor is part of the state: it is that of the pixel where the last large step ended.
inline PlaneBias bias_of(const TwoRooms& rooms, const PlaneRule& rule, double large) {
  constexpr std::size_t n = TwoRooms::kPixels;
  using Row = std::vector<double>;
  using Matrix = std::vector<Row>;
  const PlaneMoves moves = rooms.moves(rule);
  const auto accepted = [&](std::size_t x, std::size_t y, double log_ratio) {
    return std::min(1.0, rooms.target[y] / rooms.target[x] * std::exp(log_ratio));
  };
  // One matrix of small steps for each factor that a chain may carry, one if it carries none.
  const bool carries = rule.published && rule.adaptive;
  std::vector<Matrix> small;
  std::vector<float> factors;
  std::vector<std::size_t> level(n, 0);
  for (std::size_t x = 0; x < n; ++x) {
    const float factor = carries ? moves.factor(TwoRooms::center(x)) : 1.F;
    const auto found = std::find(factors.begin(), factors.end(), factor);
    level[x] = static_cast<std::size_t>(found - factors.begin());
    if (found == factors.end()) factors.push_back(factor);
  }
  for (const float factor : factors) {
    Matrix matrix(n, Row(n, 0.0));
    for (std::size_t x = 0; x < n; ++x) {
      const Vec2 from = TwoRooms::center(x);
      double away = 0.0;
      const auto add = [&](std::size_t y, double probability, double log_ratio) {
        if (y == x) return;
        matrix[x][y] += probability * accepted(x, y, log_ratio);
        away += matrix[x][y];
      };
      if (rule.published && moves.dense(from)) {
        const Vec2 to = *moves.move(from, 0);
        add(rooms.grid.index(rooms.grid.pixel(to)), 1.0, 0.0);
      } else {
        for (std::size_t y = 0; y < n; ++y) {
          const Vec2 to = TwoRooms::center(y);
          const double density = rule.published ? rooms.mutation.density(from.x, to.x, factor) *
                                                      rooms.mutation.density(from.y, to.y, factor)
                                                : moves.density(from, to);
          add(y, density / n, moves.log_ratio(from, to));
        }
      }
      matrix[x][x] = 1.0 - away;
    }
    small.push_back(std::move(matrix));
  }

  std::vector<Row> now(factors.size(), Row(n, 1.0 / static_cast<double>(n * factors.size())));
  for (int step = 0; step < 4000; ++step) {
    std::vector<Row> next(factors.size(), Row(n, 0.0));
    for (std::size_t s = 0; s < factors.size(); ++s) {
      for (std::size_t x = 0; x < n; ++x) {
        const double here = now[s][x];
        double away = 0.0;
        for (std::size_t y = 0; y < n; ++y) {
          next[s][y] += here * (1.0 - large) * small[s][x][y];
          const double jump = large / static_cast<double>(n) * accepted(x, y, 0.0);
          next[level[y]][y] += here * jump;
          away += jump;
        }
        next[s][x] += here * (large - away);
      }
    }
    now = std::move(next);
  }

  PlaneBias bias{0.0, 0.0};
  double left = 0.0;
  double true_left = 0.0;
  for (std::size_t x = 0; x < n; ++x) {
    double share = 0.0;
    for (const Row& row : now) share += row[x];
    const double truth = rooms.target[x] / rooms.sum;
    bias.pixel = std::max(bias.pixel, std::abs(share / truth - 1.0));
    if (!TwoRooms::left(static_cast<int>(x % TwoRooms::kColumns))) continue;
    left += share;
    true_left += truth;
  }
  bias.left_half = left / true_left - 1.0;
  return bias;
}

}  // namespace ajar::testing
