#include "core/distribution.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ajar {

Distribution1D::Distribution1D(std::span<const float> weights) {
  if (weights.empty()) return;
  for (const float w : weights) total_ += w;
  const double least = total_ * 0x1p-22;
  const auto raised = [&](float w) {
    if (!(total_ > 0.0)) return 1.0;
    return w > 0.F ? std::max(static_cast<double>(w), least) : 0.0;
  };
  double raised_total = 0.0;
  for (const float w : weights) raised_total += raised(w);
  cdf_.resize(weights.size() + 1);
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    cdf_[i] = static_cast<float>(sum / raised_total);
    sum += raised(weights[i]);
  }
  cdf_.back() = 1.F;
  const std::size_t n = weights.size();
  guide_.resize(n + 1);
  std::size_t cell = 0;
  for (std::size_t k = 0; k <= n; ++k) {
    const double u = std::min(static_cast<double>(k) / static_cast<double>(n),
                              static_cast<double>(kOneMinusEpsilon));
    while (static_cast<double>(cdf_[cell + 1]) <= u) ++cell;
    guide_[k] = static_cast<std::uint32_t>(cell);
  }
}

Distribution1D::Choice Distribution1D::choose(float u) const {
  u = std::min(u, kOneMinusEpsilon);
  // Exact in double precision, so the guides on both sides do enclose the cell of u.
  const auto k = static_cast<std::size_t>(static_cast<double>(u) * static_cast<double>(size()));
  // The first bound beyond u ends the cell; a cell of zero width is never the one before it.
  const auto above =
      std::upper_bound(cdf_.begin() + guide_[k] + 1, cdf_.begin() + guide_[k + 1] + 1, u);
  const auto index = static_cast<std::size_t>(above - cdf_.begin()) - 1;
  const float width = probability(index);
  return {index, width, std::min((u - cdf_[index]) / width, kOneMinusEpsilon)};
}

float Distribution1D::probability(std::size_t index) const { return cdf_[index + 1] - cdf_[index]; }

Distribution2D::Distribution2D(std::span<const float> weights, int width, int height)
    : width_(width), height_(height) {
  const auto columns = static_cast<std::size_t>(width);
  if (width <= 0 || height <= 0 || weights.size() != columns * static_cast<std::size_t>(height)) {
    throw std::invalid_argument("Distribution2D: weights do not fit the grid");
  }
  std::vector<float> totals;
  for (int y = 0; y < height; ++y) {
    rows_.emplace_back(weights.subspan(static_cast<std::size_t>(y) * columns, columns));
    totals.push_back(static_cast<float>(rows_.back().total()));
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
  const auto row = marginal_.choose(u.y);
  const auto column = rows_[row.index].choose(u.x);
  return {{place(column, width_), place(row, height_)},
          row.probability * column.probability * static_cast<float>(width_) *
              static_cast<float>(height_)};
}

float Distribution2D::pdf(const Vec2& uv) const {
  const int x = cell_of(uv.x, width_);
  const int y = cell_of(uv.y, height_);
  return marginal_.probability(static_cast<std::size_t>(y)) *
         rows_[static_cast<std::size_t>(y)].probability(static_cast<std::size_t>(x)) *
         static_cast<float>(width_) * static_cast<float>(height_);
}

}  // namespace ajar
