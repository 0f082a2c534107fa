#include "image/hdr_flip.h"

#include <algorithm>
#include <cmath>

#include "core/parallel_for.h"
#include "image/tone_curve.h"

namespace ajar {

namespace {
/// Display value (before encoding) of the ends of the range at these exposures.
constexpr double kTarget = 0.85;

/// The linear value that `filmic_curve` maps to `target`.
double inverse_filmic(double target) {
  double low = 0.0;
  double high = 1e3;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (filmic_curve(static_cast<float>(middle)) < target ? low : high) = middle;
  }
  return low;
}

/// Median as the mean of the two middle values if their number is even.
double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

std::vector<float> tone_mapped(std::span<const float> linear, double exposure) {
  std::vector<float> display(linear.size());
  parallel_for(display.size(), [&](std::size_t i) {
    display[i] = tone_map(linear[i], ToneMap::Filmic, static_cast<float>(exposure));
  });
  return display;
}
}  // namespace

std::optional<ExposureRange> hdr_flip_exposures(std::span<const float> reference) {
  std::vector<double> luminances;
  for (std::size_t i = 0; i + 2 < reference.size(); i += 3) {
    const auto lit = [&](std::size_t c) { return std::max(double{reference[i + c]}, 0.0); };
    luminances.push_back(0.2126 * lit(0) + 0.7152 * lit(1) + 0.0722 * lit(2));
  }
  if (luminances.empty()) return std::nullopt;
  const double brightest = *std::max_element(luminances.begin(), luminances.end());
  if (!(brightest > 0.0)) return std::nullopt;
  double middle = median(luminances);
  if (middle <= 0.0) {
    std::erase(luminances, 0.0);
    middle = median(std::move(luminances));
  }
  const double target = inverse_filmic(kTarget);
  ExposureRange range{std::log2(target / brightest), std::log2(target / middle), 2};
  range.count = std::max(2, static_cast<int>(std::ceil(range.stop - range.start)));
  return range;
}

std::vector<float> hdr_flip_map(std::span<const float> image, std::span<const float> reference,
                                Vec2i size, const ExposureRange& exposures,
                                double pixels_per_degree) {
  std::vector<float> largest;
  for (int i = 0; i < exposures.count; ++i) {
    const std::vector<float> map =
        flip_map(tone_mapped(image, exposures.at(i)), tone_mapped(reference, exposures.at(i)), size,
                 pixels_per_degree);
    largest.resize(map.size());
    std::transform(map.begin(), map.end(), largest.begin(), largest.begin(),
                   [](float a, float b) { return std::max(a, b); });
  }
  return largest;
}

}  // namespace ajar
