#include "mcmc/primary/plane_moves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "mcmc/counter_random.h"
#include "mcmc/primary/heuristics.h"
#include "mcmc/primary/step_sizes.h"

namespace ajar {

namespace {

constexpr std::array<Vec2i, 8> kSteps = {Vec2i(-1, -1), Vec2i(0, -1), Vec2i(1, -1), Vec2i(-1, 0),
                                         Vec2i(1, 0),   Vec2i(-1, 1), Vec2i(0, 1),  Vec2i(1, 1)};

/// h of He et al. 2020, section 2.2, from the visits of a pixel and its neighbours.
float factor_of(const PlaneRule& rule, double variance) {
  double factor = 1.0;
  if (variance > rule.uneven) factor = std::min(1.0, rule.shorten / variance);
  // The paper asks for h2 > 1, which λ2·variance alone does not give in very even places.
  if (variance < rule.even) factor = std::max(1.0, rule.lengthen * variance);
  return std::clamp(static_cast<float>(factor), PrimaryHeuristics::kShortestFactor,
                    StepSizes::kLargest);
}

}  // namespace

double PlaneRule::visits_needed() const {
  if (adaptive && neighbours) return std::min(adaptive_visits, neighbour_visits);
  return adaptive ? adaptive_visits : neighbour_visits;
}

PlaneMoves::PlaneMoves(const RasterGrid& grid, const PlaneRule& rule,
                       std::span<const PixelVisits> pixels, const Mutation& mutation,
                       const std::array<float, 2>& scales)
    : grid_(grid),
      rule_(rule),
      pixels_(pixels.begin(), pixels.end()),
      factors_(pixels.size(), 1.F),
      mutation_(mutation),
      scales_(scales) {
  const Vec2i size = grid_.size();
  if (pixels_.size() != static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y)) {
    throw std::invalid_argument("a map of visits needs one entry for each pixel");
  }
  if (size.x < 3 || size.y < 3) rule_.neighbours = false;
  if (!rule_.adaptive) return;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const std::size_t own = grid_.index({x, y});
      const double visits = double{pixels_[own].visits};
      if (visits < rule_.adaptive_visits) continue;
      double sum = visits;
      double squares = visits * visits;
      for (const Vec2i& step : kSteps) {
        const double other = double{pixels_[grid_.index(grid_.neighbour({x, y}, step))].visits};
        sum += other;
        squares += other * other;
      }
      const double mean = sum / 9.0;
      factors_[own] = factor_of(rule_, std::max(0.0, squares / 9.0 - mean * mean));
    }
  }
}

bool PlaneMoves::dense(const Vec2i& pixel) const {
  return rule_.neighbours && double{pixels_[grid_.index(pixel)].visits} >= rule_.neighbour_visits;
}

std::array<double, PlaneMoves::kNeighbours> PlaneMoves::weights(const Vec2i& pixel) const {
  std::array<PixelVisits, kNeighbours> around;
  const PixelVisits& own = pixels_[grid_.index(pixel)];
  double visits = double{own.visits};
  double light = double{own.light};
  for (std::size_t i = 0; i < kNeighbours; ++i) {
    around[i] = pixels_[grid_.index(grid_.neighbour(pixel, kSteps[i]))];
    visits += double{around[i].visits};
    light += double{around[i].light};
  }
  std::array<double, kNeighbours> result;
  for (std::size_t i = 0; i < kNeighbours; ++i) {
    const double bright = light > 0.0 ? double{around[i].light} / light : 0.0;
    const double busy = visits > 0.0 ? double{around[i].visits} / visits : 0.0;
    result[i] = std::exp(bright - busy);
  }
  return result;
}

std::array<float, 2> PlaneMoves::scaled(float factor) const {
  return {std::min(scales_[0] * factor, StepSizes::kLargest),
          std::min(scales_[1] * factor, StepSizes::kLargest)};
}

std::optional<Vec2> PlaneMoves::move(const Vec2& from, std::uint64_t key) const {
  const Vec2i pixel = grid_.pixel(from);
  if (dense(pixel)) {
    const std::array<double, kNeighbours> shares = weights(pixel);
    std::size_t chosen = 0;
    if (rule_.published) {
      chosen =
          static_cast<std::size_t>(std::max_element(shares.begin(), shares.end()) - shares.begin());
    } else {
      double left =
          to_unit_double(counter_bits(key, 0)) * std::accumulate(shares.begin(), shares.end(), 0.0);
      while (chosen + 1 < kNeighbours && left >= shares[chosen]) left -= shares[chosen++];
    }
    return grid_.place(grid_.neighbour(pixel, kSteps[chosen]), counter_bits(key, 1),
                       counter_bits(key, 2));
  }
  const float own_factor = factors_[grid_.index(pixel)];
  if (rule_.published || own_factor == 1.F) return std::nullopt;
  std::array<float, 2> numbers{from.x, from.y};
  mutation_.perturb(numbers, scaled(own_factor), 1, key);
  return Vec2(numbers[0], numbers[1]);
}

double PlaneMoves::density(const Vec2& from, const Vec2& to) const {
  const Vec2i pixel = grid_.pixel(from);
  if (!dense(pixel)) {
    const std::array<float, 2> scales = scaled(factors_[grid_.index(pixel)]);
    return mutation_.density(from.x, to.x, scales[0]) * mutation_.density(from.y, to.y, scales[1]);
  }
  const std::array<double, kNeighbours> shares = weights(pixel);
  const Vec2i goal = grid_.pixel(to);
  double share = 0.0;
  for (std::size_t i = 0; i < kNeighbours; ++i) {
    if (grid_.neighbour(pixel, kSteps[i]) == goal) share += shares[i];
  }
  return share / std::accumulate(shares.begin(), shares.end(), 0.0) / grid_.area(goal);
}

double PlaneMoves::log_ratio(const Vec2& from, const Vec2& to) const {
  if (rule_.published || (ordinary(from) && ordinary(to))) return 0.0;
  const double back = density(to, from);
  // A step whose own density vanishes can come of rounding at the ends of the distribution only.
  const double forth = density(from, to);
  if (back <= 0.0 || forth <= 0.0) return -std::numeric_limits<double>::infinity();
  return std::log(back) - std::log(forth);
}

}  // namespace ajar
