#include "image/truth_guess.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "core/parallel_for.h"

namespace ajar {

namespace {

constexpr std::size_t kChannels = 3;
constexpr std::array<int, 5> kStrides = {1, 2, 4, 8, 16};
/// Relative standard error of a pixel that is good enough as it is.
constexpr float kQuiet = 0.05F;
/// Two patches look the same if their mean squared difference is at most so many times what noise
/// explains; the noise of the darker replicates is less than that of all.
constexpr float kSame = 4.F;

float square(float value) { return value * value; }
float gray(const float* rgb) { return (rgb[0] + rgb[1] + rgb[2]) / 3.F; }

class TruthGuess {
 public:
  TruthGuess(const Replicates& replicates, Vec2i size)
      : width_(size.x),
        height_(size.y),
        count_(replicates.size()),
        pictures_(count_ * kChannels * pixels()),
        patterns_(pixels()),
        noise_(pixels()) {
    parallel_for(pixels(), [&](std::size_t pixel) {
      for (std::size_t r = 0; r < count_; ++r) {
        std::copy_n(&replicates[r][kChannels * pixel], kChannels,
                    &pictures_[kChannels * (count_ * pixel + r)]);
      }
      look_at(pixel);
    });
  }

  void average(int stride) {
    std::vector<float> pictures = pictures_;
    std::vector<float> patterns = patterns_;
    std::vector<float> noise = noise_;
    parallel_for(height_, [&](int y) {
      for (int x = 0; x < width_; ++x) {
        const std::size_t pixel = index(x, y);
        if (is_quiet(pixel)) continue;
        float* sums = &pictures[count_ * kChannels * pixel];
        float weight = 1.F;
        for (int dy = -stride; dy <= stride; dy += stride) {
          for (int dx = -stride; dx <= stride; dx += stride) {
            const std::size_t other = clamped(x + dx, y + dy);
            if (other == pixel || !look_the_same(x, y, dx, dy)) continue;
            weight += 1.F;
            patterns[pixel] += patterns_[other];
            noise[pixel] += noise_[other];
            const float* values = &pictures_[count_ * kChannels * other];
            for (std::size_t i = 0; i < count_ * kChannels; ++i) sums[i] += values[i];
          }
        }
        for (std::size_t i = 0; i < count_ * kChannels; ++i) sums[i] /= weight;
        patterns[pixel] /= weight;
        noise[pixel] /= weight * weight;
      }
    });
    pictures_ = std::move(pictures);
    patterns_ = std::move(patterns);
    noise_ = std::move(noise);
  }

  std::vector<float> medians() const {
    std::vector<float> all(kChannels * pixels());
    std::vector<float> values(count_);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::size_t first = i / kChannels * count_ * kChannels + i % kChannels;
      for (std::size_t r = 0; r < count_; ++r) values[r] = pictures_[first + r * kChannels];
      std::sort(values.begin(), values.end());
      all[i] = 0.5F * (values[(count_ - 1) / 2] + values[count_ / 2]);
    }
    return all;
  }

 private:
  std::size_t pixels() const {
    return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }
  std::size_t clamped(int x, int y) const {
    return index(std::clamp(x, 0, width_ - 1), std::clamp(y, 0, height_ - 1));
  }

  /// Pattern and noise of a pixel, of all replicates but the brightest, if there are two others.
  void look_at(std::size_t pixel) {
    std::vector<float> values(count_);
    for (std::size_t r = 0; r < count_; ++r) {
      values[r] = gray(&pictures_[kChannels * (count_ * pixel + r)]);
    }
    if (count_ > 2) values.erase(std::max_element(values.begin(), values.end()));
    const auto n = static_cast<float>(values.size());
    patterns_[pixel] = std::accumulate(values.begin(), values.end(), 0.F) / n;
    float squares = 0.F;
    for (const float value : values) squares += square(value - patterns_[pixel]);
    noise_[pixel] = squares / (n * (n - 1.F));
  }

  bool is_quiet(std::size_t pixel) const {
    const float* values = &pictures_[count_ * kChannels * pixel];
    const auto n = static_cast<float>(count_);
    float mean = 0.F;
    for (std::size_t r = 0; r < count_; ++r) mean += gray(values + kChannels * r) / n;
    float squares = 0.F;
    for (std::size_t r = 0; r < count_; ++r) {
      squares += square(gray(values + kChannels * r) - mean);
    }
    return mean > 0.F && squares <= square(kQuiet * mean) * n * (n - 1.F);
  }

  /// The 3×3 pixels around two places.
  bool look_the_same(int x, int y, int dx, int dy) const {
    float difference = 0.F;
    float expected = 0.F;
    for (int v = std::max(0, y - 1); v <= std::min(height_ - 1, y + 1); ++v) {
      for (int u = std::max(0, x - 1); u <= std::min(width_ - 1, x + 1); ++u) {
        const std::size_t here = index(u, v);
        const std::size_t there = clamped(u + dx, v + dy);
        difference += square(patterns_[here] - patterns_[there]);
        expected += noise_[here] + noise_[there];
      }
    }
    return difference <= kSame * expected;
  }

  int width_;
  int height_;
  std::size_t count_;
  std::vector<float> pictures_;  ///< all replicates of a pixel side by side
  std::vector<float> patterns_;
  std::vector<float> noise_;  ///< variances of the patterns
};

}  // namespace

std::vector<float> guess_truth(const Replicates& replicates, Vec2i size) {
  const auto values =
      kChannels * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  const auto fits = [&](const std::vector<float>& image) { return image.size() == values; };
  if (replicates.size() < 2 || !std::all_of(replicates.begin(), replicates.end(), fits)) {
    throw std::invalid_argument("guess_truth: needs two replicates or more of the picture's size");
  }
  TruthGuess guess(replicates, size);
  for (const int stride : kStrides) guess.average(stride);
  return guess.medians();
}

}  // namespace ajar
