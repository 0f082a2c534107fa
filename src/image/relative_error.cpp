#include "image/relative_error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

#include "image/blur.h"
#include "image/channels.h"
#include "image/heuristics.h"
#include "image/plane.h"
#include "image/smoothed_reference.h"

namespace ajar {

namespace {

constexpr std::size_t kPlace = ImageHeuristics::kPlace;

/// t² + 0.01 μ².
class Denominator {
 public:
  explicit Denominator(double level) : floor_(0.01 * level * level) {}
  double operator()(double truth) const { return truth * truth + floor_; }

 private:
  double floor_;
};

/// Squared relative error of each pixel, summed over its channels: of values whose standard errors
/// are `errors`. Empty if all is black.
std::vector<double> errors_of_pixels(std::span<const float> errors, std::span<const float> truth) {
  double level = median_lit(truth);
  // No two replicates agree on any light: of a value that one alone has, this is the mean.
  if (level == 0.0) level = median_lit(errors);
  if (level == 0.0) return {};
  const Denominator denominator(level);
  std::vector<double> of_pixels(truth.size() / kChannels);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double error = errors[i];
    of_pixels[i / kChannels] += error * error / denominator(truth[i]);
  }
  return of_pixels;
}

/// The estimate, but nowhere less than the picture itself around a pixel: rare paths are in no
/// median, and a pixel of which one replicate has a firefly would count as black.
std::vector<float> brightened(std::vector<float> truth, std::span<const float> picture,
                              Vec2i size) {
  std::vector<Plane> around = planes_of(size, picture);
  const SeparableKernel kernel = box_kernel(ImageHeuristics::kAroundFirefly);
  for (Plane& channel : around) channel = filter_plane(channel, kernel);
  const std::vector<float> least = interleaved(around);
  std::transform(truth.begin(), truth.end(), least.begin(), truth.begin(),
                 [](float a, float b) { return std::max(a, b); });
  return truth;
}

double sum_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Root mean square of relative errors; each pixel holds its squares summed over channels.
double root_mean(std::span<const double> of_pixels) {
  return std::sqrt(sum_of(of_pixels) / static_cast<double>(kChannels * of_pixels.size()));
}

/// (Σ e)² / Σ e².
double effective_number(std::span<const double> values) {
  const double sum = sum_of(values);
  double squares = 0.0;
  for (const double value : values) squares += value / sum * (value / sum);
  return squares > 0.0 ? 1.0 / squares : 0.0;
}

std::vector<double> sums_of_places(std::span<const double> of_pixels, Vec2i size) {
  const auto width = static_cast<std::size_t>(size.x);
  const std::size_t columns = (width + kPlace - 1) / kPlace;
  const std::size_t rows = (static_cast<std::size_t>(size.y) + kPlace - 1) / kPlace;
  std::vector<double> sums(columns * rows);
  for (std::size_t i = 0; i < of_pixels.size(); ++i) {
    sums[i / width / kPlace * columns + i % width / kPlace] += of_pixels[i];
  }
  return sums;
}

double share_that_makes_half(std::vector<double> values) {
  std::sort(values.begin(), values.end(), std::greater<>());
  const double half = 0.5 * sum_of(values);
  double sum = 0.0;
  std::size_t count = 0;
  while (count < values.size() && sum < half) sum += values[count++];
  return static_cast<double>(count) / static_cast<double>(values.size());
}

}  // namespace

std::optional<double> relative_error(std::span<const float> picture, std::span<const float> truth) {
  if (picture.size() != truth.size()) {
    throw std::invalid_argument("relative_error: picture and truth differ in size");
  }
  const double level = median_lit(truth);
  if (level == 0.0) return std::nullopt;
  const Denominator denominator(level);
  double sum = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double error = double{picture[i]} - double{truth[i]};
    sum += error * error / denominator(truth[i]);
  }
  return std::sqrt(sum / static_cast<double>(truth.size()));
}

std::optional<RelativeError> estimate_relative_error(Replicates replicates, Vec2i size) {
  const std::vector<float> errors = standard_error(replicates);
  const std::vector<float> picture = replicate_mean(replicates);
  std::vector<float> truth = smoothed_reference(std::move(replicates), size);
  const std::vector<double> of_pixels = errors_of_pixels(errors, truth);
  if (of_pixels.empty()) return std::nullopt;
  RelativeError found{};
  found.value = root_mean(of_pixels);
  if (!std::isfinite(found.value)) return std::nullopt;
  if (found.value == 0.0) return found;
  const std::vector<double> of_places = sums_of_places(of_pixels, size);
  found.places = effective_number(of_places);
  const double fewest =
      std::min(ImageHeuristics::kFewestPlaces,
               ImageHeuristics::kFewestOfPlaces * static_cast<double>(of_places.size()));
  found.has_fireflies = found.places < fewest;
  found.half_of_it = share_that_makes_half(of_pixels);
  if (found.has_fireflies) {
    found.value = root_mean(errors_of_pixels(errors, brightened(std::move(truth), picture, size)));
  }
  return found;
}

std::vector<ErrorAtScale> estimate_errors_by_scale(const Replicates& replicates, Vec2i size) {
  const std::vector<float> truth = smoothed_reference(replicates, size);
  std::vector<ErrorAtScale> found;
  for (const double sigma : kErrorScales) {
    const std::vector<double> of_pixels = errors_of_pixels(
        standard_error(blurred(replicates, size, sigma)), blurred(truth, size, sigma));
    if (of_pixels.empty()) return {};
    found.push_back({sigma, root_mean(of_pixels)});
  }
  return found;
}

std::uint64_t error_estimate_bytes(int replicates) {
  // The replicates side by side, patterns and noise, all of it twice while it is filtered; errors;
  // and the replicates as they are kept for the next scale.
  const auto pictures = static_cast<std::uint64_t>(replicates) * kChannels;
  return sizeof(float) * (2 * (pictures + 2) + 2 * kChannels + pictures);
}

}  // namespace ajar
