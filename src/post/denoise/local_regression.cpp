#include "post/denoise/local_regression.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

#include "core/parallel_for.h"
#include "image/channels.h"
#include "post/heuristics.h"

namespace ajar {

namespace {

constexpr int kWindow = PostHeuristics::kRegressionWindow;
constexpr int kPatch = PostHeuristics::kRegressionPatch;
// Size of a tile: lanes, so that the compiler vectorises loops over them.
constexpr int kWidth = 32;
constexpr int kHeight = 16;
constexpr std::size_t kPixels = std::size_t{kWidth} * kHeight;
constexpr std::size_t kMostSlopes = 8;
constexpr std::size_t kLevels = 1 + kChannels;  ///< sums of weights, and of weighted colours

/// Differences of the guide that are smaller than its root are none.
constexpr float kLeastVariance = 1e-4F;

using Lanes = std::array<float, kPixels>;

/// A part of some planes, with `border` pixels around; beyond the border of the planes their
/// pixels repeat.
class Part {
 public:
  Part(const std::vector<Plane>& planes, Vec2i corner, int border)
      : border_(border), stride_(kWidth + 2 * border) {
    const int rows = kHeight + 2 * border;
    values_.reserve(planes.size() * static_cast<std::size_t>(rows * stride_));
    for (const Plane& plane : planes) {
      for (int y = corner.y - border; y < corner.y - border + rows; ++y) {
        const int row = std::clamp(y, 0, plane.size.y - 1);
        for (int x = corner.x - border; x < corner.x - border + stride_; ++x) {
          values_.push_back(plane.at(std::clamp(x, 0, plane.size.x - 1), row));
        }
      }
    }
  }
  /// Pixels of a row, from column `x` on; both relative to the tile.
  const float* row(std::size_t plane, int x, int y) const {
    const int rows = kHeight + 2 * border_;
    return values_.data() + (static_cast<std::ptrdiff_t>(plane) * rows + y + border_) * stride_ +
           x + border_;
  }

 private:
  int border_;
  int stride_;
  std::vector<float> values_;
};

/// Distance of the guide around each pixel of a tile from that around the pixel at an offset,
/// beyond the noise; 0 for none, of 1 where it is as large as noise.
class PatchDistance {
 public:
  PatchDistance(const Part& guide, const Part& variance) : guide_(guide), variance_(variance) {}

  void find(Vec2i offset, Lanes& distance) {
    for (int y = 0; y < kRows; ++y) {
      std::array<float, kRowWidth> row{};
      for (std::size_t c = 0; c < kChannels; ++c) add_differences(c, y - kPatch, offset, row);
      for (int x = 0; x < kWidth; ++x) {
        float sum = 0.F;
        for (int i = 0; i <= 2 * kPatch; ++i) sum += row[static_cast<std::size_t>(x + i)];
        sums_[static_cast<std::size_t>(y * kWidth + x)] = sum;
      }
    }
    constexpr int kSide = 2 * kPatch + 1;
    constexpr float kScale = 1.F / static_cast<float>(kSide * kSide * static_cast<int>(kChannels));
    for (std::size_t i = 0; i < kPixels; ++i) {
      float sum = 0.F;
      for (std::size_t k = 0; k < kSide; ++k) sum += sums_[i + k * kWidth];
      distance[i] = std::max(0.F, sum * kScale);
    }
  }

 private:
  static constexpr int kRows = kHeight + 2 * kPatch;
  static constexpr int kRowWidth = kWidth + 2 * kPatch;

  void add_differences(std::size_t channel, int y, Vec2i offset,
                       std::array<float, kRowWidth>& row) const {
    const float* here = guide_.row(channel, -kPatch, y);
    const float* there = guide_.row(channel, offset.x - kPatch, y + offset.y);
    const float* noise_here = variance_.row(channel, -kPatch, y);
    const float* noise_there = variance_.row(channel, offset.x - kPatch, y + offset.y);
    constexpr float kTolerance =
        PostHeuristics::kRegressionTolerance * PostHeuristics::kRegressionTolerance;
    for (std::size_t x = 0; x < kRowWidth; ++x) {
      const float difference = here[x] - there[x];
      const float expected = noise_here[x] + std::min(noise_here[x], noise_there[x]);
      row[x] += (difference * difference - expected) /
                (kLeastVariance + kTolerance * (noise_here[x] + noise_there[x]));
    }
  }

  const Part& guide_;
  const Part& variance_;
  std::array<float, std::size_t{kRows} * kWidth> sums_{};
};

/// Sums for weighted least squares at each pixel of a tile. Models are relative to the pixel: their
/// value there is their constant.
class Sums {
 public:
  explicit Sums(std::size_t slopes)
      : slopes_(slopes), sums_(kLevels + slopes * (slopes + 1) / 2 + slopes * kLevels) {}

  /// `x`: explanatory values of the pixels at an offset, relative to those here.
  void add(const Lanes& weight, const std::array<Lanes, kMostSlopes>& x,
           const std::array<Lanes, kChannels>& colour) {
    std::size_t at = 0;
    add_lanes(weight, sums_[at++]);
    for (const Lanes& c : colour) add_product(weight, c, sums_[at++]);
    for (std::size_t i = 0; i < slopes_; ++i) {
      for (std::size_t k = 0; k < kPixels; ++k) weighted_[k] = weight[k] * x[i][k];
      add_lanes(weighted_, sums_[at++]);
      for (const Lanes& c : colour) add_product(weighted_, c, sums_[at++]);
      for (std::size_t j = 0; j <= i; ++j) add_product(weighted_, x[j], sums_[at++]);
    }
  }

  /// Predictions of the models at a pixel.
  std::array<float, kChannels> solve(std::size_t pixel) const {
    const float whole = sums_[0][pixel];
    std::size_t at = 1;
    const auto next = [&] { return sums_[at++][pixel] / whole; };
    std::array<float, kChannels> mean{};
    for (float& value : mean) value = next();
    std::array<float, kMostSlopes> centre{};
    std::array<std::array<float, kChannels>, kMostSlopes> right{};
    std::array<std::array<float, kMostSlopes>, kMostSlopes> matrix{};
    for (std::size_t i = 0; i < slopes_; ++i) {
      centre[i] = next();
      for (std::size_t c = 0; c < kChannels; ++c) right[i][c] = next() - centre[i] * mean[c];
      for (std::size_t j = 0; j <= i; ++j) matrix[i][j] = next() - centre[i] * centre[j];
      matrix[i][i] = std::max(matrix[i][i], 0.F) + PostHeuristics::kRidge;
    }
    factorize(matrix);
    std::array<float, kChannels> value = mean;
    for (std::size_t c = 0; c < kChannels; ++c) {
      // Only the constant is asked for: mean − centreᵀ (L Lᵀ)⁻¹ right.
      std::array<float, kMostSlopes> a{};
      std::array<float, kMostSlopes> b{};
      for (std::size_t i = 0; i < slopes_; ++i) {
        a[i] = centre[i];
        b[i] = right[i][c];
        for (std::size_t j = 0; j < i; ++j) {
          a[i] -= matrix[i][j] * a[j];
          b[i] -= matrix[i][j] * b[j];
        }
        a[i] /= matrix[i][i];
        b[i] /= matrix[i][i];
        value[c] -= a[i] * b[i];
      }
    }
    return value;
  }

 private:
  static void add_lanes(const Lanes& a, Lanes& sum) {
    for (std::size_t k = 0; k < kPixels; ++k) sum[k] += a[k];
  }
  static void add_product(const Lanes& a, const Lanes& b, Lanes& sum) {
    for (std::size_t k = 0; k < kPixels; ++k) sum[k] += a[k] * b[k];
  }
  /// Cholesky: the lower triangle L of L Lᵀ.
  void factorize(std::array<std::array<float, kMostSlopes>, kMostSlopes>& m) const {
    for (std::size_t i = 0; i < slopes_; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < j; ++k) m[i][j] -= m[i][k] * m[j][k];
        m[i][j] /= m[j][j];
      }
      for (std::size_t k = 0; k < i; ++k) m[i][i] -= m[i][k] * m[i][k];
      // Rounding takes no more than a part of the ridge.
      m[i][i] = std::sqrt(std::max(m[i][i], 0.01F * PostHeuristics::kRidge));
    }
  }

  std::size_t slopes_;
  std::vector<Lanes> sums_;
  Lanes weighted_{};
};

/// exp(−distance), nearly, and 0 from 8 on.
void weights_of(const Lanes& distance, Lanes& weight) {
  for (std::size_t k = 0; k < kPixels; ++k) {
    float root = std::max(0.F, 1.F - distance[k] / 8.F);
    root *= root;
    root *= root;
    weight[k] = root * root;
  }
}

/// No weight for pixels beyond the border of the picture.
void cut(Vec2i size, Vec2i corner, Lanes& weight) {
  for (int y = 0; y < kHeight; ++y) {
    const bool is_inside = corner.y + y >= 0 && corner.y + y < size.y;
    for (int x = 0; x < kWidth; ++x) {
      if (is_inside && corner.x + x >= 0 && corner.x + x < size.x) continue;
      weight[static_cast<std::size_t>(y * kWidth + x)] = 0.F;
    }
  }
}

void fit_tile(const RegressionInput& input, Vec2i corner, std::vector<Plane>& result) {
  const Vec2i size = input.colour.front().size;
  const Part colour(input.colour, corner, kWindow);
  const Part features(input.features, corner, kWindow);
  const Part guide(input.guide, corner, kWindow + kPatch);
  const Part variance(input.variance, corner, kWindow + kPatch);
  const std::size_t of_features = input.features.size();
  const std::size_t slopes = of_features + 2;
  PatchDistance distances(guide, variance);
  Sums sums(slopes);
  Lanes distance{};
  Lanes weight{};
  std::array<Lanes, kMostSlopes> x{};
  std::array<Lanes, kChannels> there{};
  const auto lanes_of = [](const Part& part, std::size_t plane, Vec2i offset, Lanes& lanes) {
    for (int y = 0; y < kHeight; ++y) {
      std::copy_n(part.row(plane, offset.x, y + offset.y), kWidth, lanes.data() + y * kWidth);
    }
  };
  std::array<Lanes, kMostSlopes> here{};
  for (std::size_t f = 0; f < of_features; ++f) lanes_of(features, f, {0, 0}, here[f]);
  for (int dy = -kWindow; dy <= kWindow; ++dy) {
    for (int dx = -kWindow; dx <= kWindow; ++dx) {
      const Vec2i offset(dx, dy);
      distances.find(offset, distance);
      weights_of(distance, weight);
      cut(size, corner + offset, weight);
      for (std::size_t c = 0; c < kChannels; ++c) lanes_of(colour, c, offset, there[c]);
      for (std::size_t f = 0; f < of_features; ++f) {
        lanes_of(features, f, offset, x[f]);
        for (std::size_t k = 0; k < kPixels; ++k) x[f][k] -= here[f][k];
      }
      x[of_features].fill(static_cast<float>(dx) / kWindow);
      x[of_features + 1].fill(static_cast<float>(dy) / kWindow);
      sums.add(weight, x, there);
    }
  }
  for (int y = 0; y < std::min(kHeight, size.y - corner.y); ++y) {
    for (int px = 0; px < std::min(kWidth, size.x - corner.x); ++px) {
      const auto value = sums.solve(static_cast<std::size_t>(y * kWidth + px));
      for (std::size_t c = 0; c < kChannels; ++c) {
        result[c].at(corner.x + px, corner.y + y) = value[c];
      }
    }
  }
}

}  // namespace

std::vector<Plane> local_regression(const RegressionInput& input,
                                    const std::function<bool(int pixels)>& proceeds) {
  const Vec2i size = input.colour.front().size;
  std::vector<Plane> result(kChannels, Plane(size));
  const int columns = (size.x + kWidth - 1) / kWidth;
  const int rows = (size.y + kHeight - 1) / kHeight;
  std::atomic<bool> is_ended = false;
  parallel_for(columns * rows, [&](int tile) {
    if (is_ended) return;
    const Vec2i corner(tile % columns * kWidth, tile / columns * kHeight);
    fit_tile(input, corner, result);
    const int pixels = std::min(kWidth, size.x - corner.x) * std::min(kHeight, size.y - corner.y);
    if (!proceeds(pixels)) is_ended = true;
  });
  return result;
}

}  // namespace ajar
