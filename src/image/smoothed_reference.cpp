#include "image/smoothed_reference.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <utility>

#include "core/parallel_for.h"
#include "image/channels.h"
#include "image/heuristics.h"

namespace ajar {

namespace {

/// Relative to the median: squares of brighter values might not be finite.
constexpr double kMost = 1e17;

float square(float value) { return value * value; }
float gray(const float* rgb) { return (rgb[0] + rgb[1] + rgb[2]) / 3.F; }

/// Mean of some numbers and its variance.
struct Spread {
  float mean;
  float variance;
};

class ReplicateSmoother {
 public:
  /// `level`: in whose units it calculates.
  ReplicateSmoother(const Replicates& replicates, Vec2i size, double level)
      : width_(size.x),
        height_(size.y),
        count_(replicates.size()),
        level_(level),
        pictures_(count_ * kChannels * pixels()),
        patterns_(pixels()),
        noise_(pixels()) {
    parallel_for(pixels(), [&](std::size_t pixel) {
      for (std::size_t r = 0; r < count_; ++r) {
        for (std::size_t c = 0; c < kChannels; ++c) {
          const double value = double{replicates[r][kChannels * pixel + c]} / level_;
          values_of(pixel)[kChannels * r + c] =
              static_cast<float>(std::clamp(value, -kMost, kMost));
        }
      }
      const Spread spread = spread_of(pixel, count_ > 2 ? brightest(pixel) : count_);
      patterns_[pixel] = spread.mean;
      noise_[pixel] = spread.variance;
    });
  }

  /// With the neighbours that are `stride` pixels away and look the same.
  void average(int stride) {
    std::vector<float> pictures = pictures_;
    std::vector<float> patterns = patterns_;
    std::vector<float> noise = noise_;
    parallel_for(height_, [&](int y) {
      const std::vector<bool> quiet = quiet_in_row(y);
      std::vector<float> weights(static_cast<std::size_t>(width_), 1.F);
      PatchRow patches(width_);
      for (int dy = -stride; dy <= stride; dy += stride) {
        for (int dx = -stride; dx <= stride; dx += stride) {
          if ((dx == 0 && dy == 0) || y + dy < 0 || y + dy >= height_) continue;
          compare_patches(y, dx, dy, patches);
          for (int x = std::max(0, -dx); x < std::min(width_, width_ - dx); ++x) {
            if (quiet[static_cast<std::size_t>(x)] || !patches.look_the_same(x)) continue;
            const std::size_t pixel = index(x, y);
            const std::size_t other = index(x + dx, y + dy);
            weights[static_cast<std::size_t>(x)] += 1.F;
            patterns[pixel] += patterns_[other];
            noise[pixel] += noise_[other];
            float* sums = &pictures[count_ * kChannels * pixel];
            const float* values = values_of(other);
            for (std::size_t i = 0; i < count_ * kChannels; ++i) sums[i] += values[i];
          }
        }
      }
      for (int x = 0; x < width_; ++x) {
        const std::size_t pixel = index(x, y);
        const float weight = weights[static_cast<std::size_t>(x)];
        float* sums = &pictures[count_ * kChannels * pixel];
        for (std::size_t i = 0; i < count_ * kChannels; ++i) sums[i] /= weight;
        patterns[pixel] /= weight;
        noise[pixel] /= weight * weight;
      }
    });
    pictures_ = std::move(pictures);
    patterns_ = std::move(patterns);
    noise_ = std::move(noise);
  }

  /// Pixels of which replicates agree.
  std::vector<bool> quiet() const {
    std::vector<bool> all(pixels());
    for (std::size_t pixel = 0; pixel < all.size(); ++pixel) all[pixel] = is_quiet(pixel);
    return all;
  }

  /// Lower median of an even number.
  std::vector<float> medians() const {
    std::vector<float> all(kChannels * pixels());
    std::vector<float> values(count_);
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t r = 0; r < count_; ++r) {
        values[r] = values_of(i / kChannels)[kChannels * r + i % kChannels];
      }
      std::sort(values.begin(), values.end());
      const float upper = values[count_ == 2 ? 0 : count_ / 2];
      all[i] = static_cast<float>(0.5 * level_ * (double{values[(count_ - 1) / 2]} + upper));
    }
    return all;
  }

 private:
  std::size_t pixels() const {
    return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  }
  bool is_inside(int x, int y) const { return x >= 0 && x < width_ && y >= 0 && y < height_; }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }
  /// All replicates of a pixel, one after the other.
  float* values_of(std::size_t pixel) { return &pictures_[count_ * kChannels * pixel]; }
  const float* values_of(std::size_t pixel) const { return &pictures_[count_ * kChannels * pixel]; }

  std::size_t brightest(std::size_t pixel) const {
    std::size_t most = 0;
    for (std::size_t r = 1; r < count_; ++r) {
      if (gray(values_of(pixel) + kChannels * r) > gray(values_of(pixel) + kChannels * most)) {
        most = r;
      }
    }
    return most;
  }

  /// Mean over all replicates but one, if there is one of that number.
  Spread spread_of(std::size_t pixel, std::size_t without) const {
    const auto n = static_cast<float>(without < count_ ? count_ - 1 : count_);
    float mean = 0.F;
    float squares = 0.F;
    for (std::size_t r = 0; r < count_; ++r) {
      if (r != without) mean += gray(values_of(pixel) + kChannels * r) / n;
    }
    for (std::size_t r = 0; r < count_; ++r) {
      if (r != without) squares += square(gray(values_of(pixel) + kChannels * r) - mean);
    }
    return {mean, squares / (n * (n - 1.F))};
  }

  bool is_quiet(std::size_t pixel) const {
    const Spread spread = spread_of(pixel, count_);
    return spread.mean > 0.F && spread.variance <= square(ImageHeuristics::kQuiet * spread.mean);
  }

  std::vector<bool> quiet_in_row(int y) const {
    std::vector<bool> row(static_cast<std::size_t>(width_));
    for (int x = 0; x < width_; ++x) row[static_cast<std::size_t>(x)] = is_quiet(index(x, y));
    return row;
  }

  /// Differences of the 3×3 patches around the pixels of a row from those around others.
  class PatchRow {
   public:
    explicit PatchRow(int width)
        : difference_(static_cast<std::size_t>(width) + 2), expected_(difference_.size()) {}
    void clear() {
      std::fill(difference_.begin(), difference_.end(), 0.F);
      std::fill(expected_.begin(), expected_.end(), 0.F);
    }
    /// Sums over columns of three pixels; those outside of the picture, at -1 and the width, are 0.
    float* difference() { return difference_.data() + 1; }
    float* expected() { return expected_.data() + 1; }
    bool look_the_same(int x) const {
      const auto i = static_cast<std::size_t>(x);
      const float difference = difference_[i] + difference_[i + 1] + difference_[i + 2];
      const float expected = expected_[i] + expected_[i + 1] + expected_[i + 2];
      return difference <= ImageHeuristics::kSamePatch * expected;
    }

   private:
    std::vector<float> difference_;
    std::vector<float> expected_;
  };

  /// Row `y` with the one `dy` below, moved by `dx`. Column by column, which is a ninth of the work
  /// of patch by patch.
  void compare_patches(int y, int dx, int dy, PatchRow& patches) const {
    patches.clear();
    float* difference = patches.difference();
    float* expected = patches.expected();
    const int first = std::max(0, -dx);
    const int last = std::min(width_, width_ - dx);
    for (int v = std::max({0, y - 1, -dy}); v <= std::min({height_ - 1, y + 1, height_ - 1 - dy});
         ++v) {
      const float* pattern = &patterns_[index(0, v)];
      const float* noise = &noise_[index(0, v)];
      const float* other_pattern = &patterns_[index(0, v + dy)];
      const float* other_noise = &noise_[index(0, v + dy)];
      for (int u = first; u < last; ++u) {
        difference[u] += square(pattern[u] - other_pattern[u + dx]);
        expected[u] += noise[u] + other_noise[u + dx];
      }
    }
  }

  int width_;
  int height_;
  std::size_t count_;
  double level_;
  std::vector<float> pictures_;  ///< all replicates of a pixel side by side
  std::vector<float> patterns_;
  std::vector<float> noise_;  ///< variances of the patterns
};

/// Ratio of a picture's brightness to a smoothed one's: each pixel relative to the latter, so that
/// lamps do not decide.
double gain_over(std::span<const float> smoothed, std::span<const float> picture) {
  const double level = median_lit(smoothed);
  if (level == 0.0) return 1.0;
  double of_smoothed = 0.0;
  double of_picture = 0.0;
  for (std::size_t i = 0; i < smoothed.size(); ++i) {
    const double weight = 1.0 / (std::abs(double{smoothed[i]}) + level);
    of_smoothed += weight * double{smoothed[i]};
    of_picture += weight * double{picture[i]};
  }
  return of_smoothed > 0.0 && of_picture > 0.0 ? of_picture / of_smoothed : 1.0;
}

/// Edges of lamps are in one replicate of a few samples, and in no median: no pixel is darker than
/// in the picture as long as one beside it, of which replicates agree, is as bright.
class BrightEdges {
 public:
  BrightEdges(const std::vector<bool>& quiet, std::span<const float> picture, Vec2i size)
      : quiet_(quiet), picture_(picture), size_(size) {}

  /// Lower bound of a value.
  float least(int x, int y, std::size_t channel) const {
    float most = 0.F;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, size_.y - 1); ++v) {
      for (int u = std::max(x - 1, 0); u <= std::min(x + 1, size_.x - 1); ++u) {
        const std::size_t pixel = index(u, v);
        if (quiet_[pixel]) most = std::max(most, picture_[kChannels * pixel + channel]);
      }
    }
    return std::min(picture_[kChannels * index(x, y) + channel], most);
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) +
           static_cast<std::size_t>(x);
  }

  const std::vector<bool>& quiet_;
  std::span<const float> picture_;
  Vec2i size_;
};

}  // namespace

std::vector<float> smoothed_reference(Replicates replicates, Vec2i size) {
  const auto values =
      kChannels * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  const auto fits = [&](const std::vector<float>& image) { return image.size() == values; };
  if (replicates.size() < 2 || !std::all_of(replicates.begin(), replicates.end(), fits)) {
    throw std::invalid_argument(
        "smoothed_reference: needs two replicates or more of the picture's size");
  }
  const double level = median_lit(replicates.front());
  ReplicateSmoother smoother(replicates, size, level > 0.0 ? level : 1.0);
  const std::vector<float> mean = replicate_mean(replicates);
  replicates = {};
  const std::vector<bool> quiet = smoother.quiet();
  for (const int stride : ImageHeuristics::kSmoothingStrides) smoother.average(stride);
  std::vector<float> medians = smoother.medians();
  const double gain = gain_over(medians, mean);
  const BrightEdges edges(quiet, mean, size);
  parallel_for(size.y, [&](int y) {
    for (int x = 0; x < size.x; ++x) {
      for (std::size_t c = 0; c < kChannels; ++c) {
        const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x);
        float& value = medians[kChannels * (row + static_cast<std::size_t>(x)) + c];
        value = std::max(static_cast<float>(gain * double{value}), edges.least(x, y, c));
      }
    }
  });
  return medians;
}

}  // namespace ajar
