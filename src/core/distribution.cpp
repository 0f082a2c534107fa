#include "core/distribution.h"

#include <algorithm>
#include <stdexcept>

namespace ajar {

Distribution1D::Distribution1D(std::span<const float> weights) {
  if (weights.empty()) return;
  for (const float w : weights) total_ += w;
  const auto n = static_cast<double>(weights.size());
  cdf_.resize(weights.size() + 1);
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    cdf_[i] = static_cast<float>(total_ > 0.0 ? sum / total_ : static_cast<double>(i) / n);
    sum += weights[i];
  }
  cdf_.back() = 1.F;
}

Distribution1D::Choice Distribution1D::choose(float u) const {
  // The first bound beyond u ends the cell; a cell of zero width is never the one before it.
  const auto above = std::upper_bound(cdf_.begin(), cdf_.end() - 1, std::min(u, kOneMinusEpsilon));
  const auto index = static_cast<std::size_t>(above - cdf_.begin()) - 1;
  const float width = probability(index);
  return {index, width, std::min((u - cdf_[index]) / width, kOneMinusEpsilon)};
}

float Distribution1D::probability(std::size_t index) const {
  return cdf_[index + 1] - cdf_[index];
}

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

Distribution2D::Sample Distribution2D::sample(const Vec2& u) const {
  const auto row = marginal_.choose(u.y);
  const auto column = rows_[row.index].choose(u.x);
  const auto w = static_cast<float>(width_);
  const auto h = static_cast<float>(height_);
  return {{std::min((static_cast<float>(column.index) + column.u) / w, kOneMinusEpsilon),
           std::min((static_cast<float>(row.index) + row.u) / h, kOneMinusEpsilon)},
          row.probability * column.probability * w * h};
}

float Distribution2D::pdf(const Vec2& uv) const {
  const int x = std::clamp(static_cast<int>(uv.x * static_cast<float>(width_)), 0, width_ - 1);
  const int y = std::clamp(static_cast<int>(uv.y * static_cast<float>(height_)), 0, height_ - 1);
  return marginal_.probability(static_cast<std::size_t>(y)) *
         rows_[static_cast<std::size_t>(y)].probability(static_cast<std::size_t>(x)) *
         static_cast<float>(width_) * static_cast<float>(height_);
}

}  // namespace ajar
