#include "image/metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "image/blur.h"

namespace ajar {

namespace {
void check_sizes(std::span<const float> image, std::span<const float> reference) {
  if (image.size() != reference.size() || image.empty()) {
    throw std::invalid_argument("metrics: images differ in size or are empty");
  }
}

/// Mean of term(a, r) over all values.
template <typename Term>
double mean_of(std::span<const float> image, std::span<const float> reference, Term term) {
  check_sizes(image, reference);
  double sum = 0.0;
  for (std::size_t i = 0; i < image.size(); ++i)
    sum += term(double{image[i]}, double{reference[i]});
  return sum / static_cast<double>(image.size());
}

double squared_error(double a, double r) { return (a - r) * (a - r); }
double relative_squared_error(double a, double r) {
  return (a - r) * (a - r) / (r * r + kRelativeMseEpsilon);
}

/// relMSE of each pixel; infinite where it is no number.
std::vector<double> errors_of_pixels(std::span<const float> image, std::span<const float> reference,
                                     int channels) {
  check_sizes(image, reference);
  const auto per_pixel = static_cast<std::size_t>(channels);
  if (channels < 1 || image.size() % per_pixel != 0) {
    throw std::invalid_argument("metrics: the values are not whole pixels");
  }
  std::vector<double> errors(image.size() / per_pixel);
  for (std::size_t pixel = 0; pixel < errors.size(); ++pixel) {
    const std::size_t first = pixel * per_pixel;
    const double error =
        relative_mse(image.subspan(first, per_pixel), reference.subspan(first, per_pixel));
    errors[pixel] = std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
  }
  return errors;
}
}  // namespace

double mse(std::span<const float> image, std::span<const float> reference) {
  return mean_of(image, reference, squared_error);
}

double rmse(std::span<const float> image, std::span<const float> reference) {
  return std::sqrt(mse(image, reference));
}

double psnr(std::span<const float> image, std::span<const float> reference, double peak) {
  return 10.0 * std::log10(peak * peak / mse(image, reference));
}

double mae(std::span<const float> image, std::span<const float> reference) {
  return mean_of(image, reference, [](double a, double r) { return std::abs(a - r); });
}

double smape(std::span<const float> image, std::span<const float> reference) {
  return mean_of(image, reference, [](double a, double r) {
    return std::abs(a - r) / (std::abs(a) + std::abs(r) + kSmapeEpsilon);
  });
}

double relative_mse(std::span<const float> image, std::span<const float> reference) {
  return mean_of(image, reference, relative_squared_error);
}

double relative_mse_trimmed(std::span<const float> image, std::span<const float> reference,
                            int channels, double trim) {
  std::vector<double> errors = errors_of_pixels(image, reference, channels);
  const auto cut = static_cast<std::size_t>(trim * static_cast<double>(errors.size()));
  const std::size_t kept = errors.size() - std::min(cut, errors.size() - 1);
  const auto end = errors.begin() + static_cast<std::ptrdiff_t>(kept);
  std::nth_element(errors.begin(), end - 1, errors.end());
  return std::accumulate(errors.begin(), end, 0.0) / static_cast<double>(kept);
}

double relative_mse_quantile(std::span<const float> image, std::span<const float> reference,
                             double below, int channels) {
  std::vector<double> errors = errors_of_pixels(image, reference, channels);
  const auto rank = static_cast<std::ptrdiff_t>(below * static_cast<double>(errors.size() - 1));
  std::nth_element(errors.begin(), errors.begin() + rank, errors.end());
  return errors[static_cast<std::size_t>(rank)];
}

double relative_mse_at_scale(std::span<const float> image, std::span<const float> reference,
                             Vec2i size, double sigma) {
  return relative_mse(blurred(image, size, sigma), blurred(reference, size, sigma));
}

}  // namespace ajar
