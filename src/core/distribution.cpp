#include "core/distribution.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ajar {

Distribution1D::Distribution1D(std::span<const float> weights) {
  if (weights.empty()) return;
  cdf_.resize(weights.size() + 1);
  guide_.resize(guides_for(weights.size()) + 1);
  total_ = fill(weights, cdf_.data(), guide_.data());
}

double Distribution1D::fill(std::span<const float> weights, float* cdf, std::uint32_t* guide) {
  double total = 0.0;
  for (const float w : weights) total += w;
  const double least = total * 0x1p-22;
  const auto raised = [&](float w) {
    if (!(total > 0.0)) return 1.0;
    return w > 0.F ? std::max(static_cast<double>(w), least) : 0.0;
  };
  double raised_total = 0.0;
  for (const float w : weights) raised_total += raised(w);
  double sum = 0.0;
  const std::size_t n = weights.size();
  for (std::size_t i = 0; i < n; ++i) {
    cdf[i] = static_cast<float>(sum / raised_total);
    sum += raised(weights[i]);
  }
  cdf[n] = 1.F;
  const std::size_t guides = guides_for(n);
  std::size_t cell = 0;
  for (std::size_t k = 0; k <= guides; ++k) {
    const double u = std::min(static_cast<double>(k) / static_cast<double>(guides),
                              static_cast<double>(kOneMinusEpsilon));
    while (static_cast<double>(cdf[cell + 1]) <= u) ++cell;
    guide[k] = static_cast<std::uint32_t>(cell);
  }
  return total;
}

Distribution2D::Distribution2D(std::span<const float> weights, int width, int height)
    : width_(width), height_(height) {
  const auto columns = static_cast<std::size_t>(width);
  const auto rows = static_cast<std::size_t>(height);
  if (width <= 0 || height <= 0 || weights.size() != columns * rows) {
    throw std::invalid_argument("Distribution2D: weights do not fit the grid");
  }
  row_guides_ = Distribution1D::guides_for(columns);
  cdfs_.resize(rows * (columns + 1));
  guides_.resize(rows * (row_guides_ + 1));
  std::vector<float> totals(rows);
  for (std::size_t y = 0; y < rows; ++y) {
    totals[y] = static_cast<float>(Distribution1D::fill(weights.subspan(y * columns, columns),
                                                        cdfs_.data() + y * (columns + 1),
                                                        guides_.data() + y * (row_guides_ + 1)));
  }
  marginal_ = Distribution1D(totals);
}

namespace {
/// Cell of x among `cells` of [0, 1).
int cell_of(float x, int cells) {
  return std::clamp(static_cast<int>(x * static_cast<float>(cells)), 0, cells - 1);
}
}  // namespace

float Distribution2D::place(const Distribution1D::Choice& choice, int cells) {
  const int cell = static_cast<int>(choice.index);
  float x = (static_cast<float>(choice.index) + choice.u) / static_cast<float>(cells);
  // Rounding may carry x over the border of its cell, where the density is another.
  while (cell_of(x, cells) < cell) x = std::nextafter(x, 1.F);
  while (cell_of(x, cells) > cell) x = std::nextafter(x, 0.F);
  return std::min(x, kOneMinusEpsilon);
}

Distribution2D::Sample Distribution2D::sample(const Vec2& u) const {
  const auto chosen_row = marginal_.choose(u.y);
  const auto column = row(chosen_row.index).choose(u.x);
  return {{place(column, width_), place(chosen_row, height_)},
          chosen_row.probability * column.probability * static_cast<float>(width_) *
              static_cast<float>(height_)};
}

Vec2 Distribution2D::invert(const Vec2& uv) const {
  const int x = cell_of(uv.x, width_);
  const int y = cell_of(uv.y, height_);
  const auto within = [](float v, int cells, int cell) {
    const float u = v * static_cast<float>(cells) - static_cast<float>(cell);
    return std::clamp(u, 0.F, kOneMinusEpsilon);
  };
  const auto column = static_cast<std::size_t>(x);
  const auto line = static_cast<std::size_t>(y);
  return {row(line).invert(column, within(uv.x, width_, x)),
          marginal_.invert(line, within(uv.y, height_, y))};
}

float Distribution2D::pdf(const Vec2& uv) const {
  const int x = cell_of(uv.x, width_);
  const int y = cell_of(uv.y, height_);
  return marginal_.probability(static_cast<std::size_t>(y)) *
         row(static_cast<std::size_t>(y)).probability(static_cast<std::size_t>(x)) *
         static_cast<float>(width_) * static_cast<float>(height_);
}

}  // namespace ajar
