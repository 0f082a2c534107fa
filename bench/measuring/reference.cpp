#include "measuring/reference.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "image/metrics.h"
#include "image/relative_error.h"

namespace ajar::bench {

namespace {

/// A difference is never taken to be all the reference's fault: weights stay between 0 and 1.
double unexplained(double difference, double explained) {
  constexpr double kLeastShare = 0.01;
  return std::max(difference - explained, kLeastShare * difference);
}

/// A pixel as it is measured.
struct PixelError {
  double own = 0.0;         ///< the product of its differences from both references
  double seen = 0.0;        ///< squared difference from their mean
  double references = 0.0;  ///< squared difference between them
};

/// Keeps the pixels of which `value` is least, all but a share of them.
void leave_out(std::vector<PixelError>& pixels, double share, double PixelError::*value) {
  const auto kept = static_cast<std::ptrdiff_t>(std::ceil((1.0 - share) * pixels.size()));
  std::nth_element(pixels.begin(), pixels.begin() + kept - 1, pixels.end(),
                   [&](const PixelError& a, const PixelError& b) { return a.*value < b.*value; });
  pixels.resize(static_cast<std::size_t>(kept));
}

double mean_own(const std::vector<PixelError>& pixels) {
  double sum = 0.0;
  for (const PixelError& pixel : pixels) sum += pixel.own;
  return sum / static_cast<double>(pixels.size());
}

/// Floor of (1 − weight)·a + weight·b.
double mixed_floor(double a, double b, double weight) {
  return (1.0 - weight) * (1.0 - weight) * a + weight * weight * b;
}

}  // namespace

NoiseFloor noise_floor(std::span<const float> picture, std::span<const float> standard_error) {
  std::vector<float> off_by_one_error(picture.begin(), picture.end());
  for (std::size_t i = 0; i < picture.size(); ++i) off_by_one_error[i] += standard_error[i];
  return {relative_mse(off_by_one_error, picture), relative_mse_trimmed(off_by_one_error, picture)};
}

OwnError own_error(std::span<const float> picture, std::span<const float> first,
                   std::span<const float> second) {
  constexpr std::size_t kChannels = 3;
  constexpr double kDisputed = 0.01;
  constexpr double kWorst = 0.001;
  if (picture.empty() || picture.size() % kChannels != 0 || first.size() != picture.size() ||
      second.size() != picture.size()) {
    throw std::invalid_argument("own error: a picture and references of different sizes");
  }
  std::vector<PixelError> pixels(picture.size() / kChannels);
  for (std::size_t i = 0; i < picture.size(); ++i) {
    const double a = picture[i] - double{first[i]};
    const double b = picture[i] - double{second[i]};
    const double mean = 0.5 * (double{first[i]} + double{second[i]});
    const double unit = kChannels * (mean * mean + kRelativeMseEpsilon);
    PixelError& pixel = pixels[i / kChannels];
    pixel.own += a * b / unit;
    pixel.seen += 0.25 * (a + b) * (a + b) / unit;
    pixel.references += (a - b) * (a - b) / unit;
  }
  leave_out(pixels, kDisputed, &PixelError::references);
  OwnError error;
  error.plain = mean_own(pixels);
  leave_out(pixels, kWorst, &PixelError::seen);
  error.trimmed = mean_own(pixels);
  return error;
}

ReferencePair reference_pair(std::span<const std::array<std::vector<float>, 2>> by_method) {
  if (by_method.empty()) throw std::invalid_argument("references: by no method");
  const std::size_t values = by_method.front()[0].size();
  std::vector<double> weights;
  for (const auto& [first, second] : by_method) {
    if (first.size() != values || second.size() != values) {
      throw std::invalid_argument("references: pictures of different sizes");
    }
    constexpr double kNone = 1e-12;
    weights.push_back(1.0 / std::max(kNone, relative_mse_trimmed(first, second)));
  }
  const double all = std::accumulate(weights.begin(), weights.end(), 0.0);
  ReferencePair pair;
  for (std::vector<float>& half : pair.halves) half.resize(values);
  pair.mean.resize(values);
  std::vector<float> off_by_one_error(values);
  for (std::size_t i = 0; i < values; ++i) {
    std::array<double, 2> sums{};
    for (std::size_t m = 0; m < by_method.size(); ++m) {
      for (std::size_t h = 0; h < sums.size(); ++h) {
        sums[h] += weights[m] / all * double{by_method[m][h][i]};
      }
    }
    for (std::size_t h = 0; h < sums.size(); ++h) pair.halves[h][i] = static_cast<float>(sums[h]);
    pair.mean[i] = static_cast<float>(0.5 * (sums[0] + sums[1]));
    off_by_one_error[i] = pair.mean[i] + static_cast<float>(0.5 * std::abs(sums[0] - sums[1]));
  }
  pair.floor = {relative_mse(off_by_one_error, pair.mean),
                relative_mse_trimmed(off_by_one_error, pair.mean)};
  pair.error = relative_error(off_by_one_error, pair.mean).value_or(0.0);
  return pair;
}

Reference average(std::span<const ReferencePart> parts) {
  Reference reference;
  for (const ReferencePart& part : parts) {
    reference.samples += part.samples;
    reference.cpu_seconds += part.cpu_seconds;
  }
  reference.parts = parts.size();
  const std::size_t values = parts.front().picture.size();
  std::vector<double> sum(values);
  std::vector<double> variance(values);
  for (const ReferencePart& part : parts) {
    const double weight =
        static_cast<double>(part.samples) / static_cast<double>(reference.samples);
    for (std::size_t i = 0; i < values; ++i) {
      sum[i] += weight * part.picture[i];
      const double error = weight * part.standard_error[i];
      variance[i] += error * error;
    }
  }
  reference.picture.assign(sum.begin(), sum.end());
  std::vector<float> standard_error(values);
  std::transform(variance.begin(), variance.end(), standard_error.begin(),
                 [](double v) { return static_cast<float>(std::sqrt(v)); });
  reference.floor = noise_floor(reference.picture, standard_error);
  return reference;
}

Reference average_with(const Reference& reference, std::span<const float> independent) {
  const NoiseFloor& ours = reference.floor;
  const NoiseFloor theirs{
      unexplained(relative_mse(independent, reference.picture), ours.plain),
      unexplained(relative_mse_trimmed(independent, reference.picture), ours.trimmed)};
  const double total = ours.trimmed + theirs.trimmed;
  const double weight = total > 0.0 ? ours.trimmed / total : 0.5;
  Reference mixed = reference;
  for (std::size_t i = 0; i < mixed.picture.size(); ++i) {
    mixed.picture[i] =
        static_cast<float>((1.0 - weight) * mixed.picture[i] + weight * independent[i]);
  }
  mixed.floor = {mixed_floor(ours.plain, theirs.plain, weight),
                 mixed_floor(ours.trimmed, theirs.trimmed, weight)};
  return mixed;
}

}  // namespace ajar::bench
