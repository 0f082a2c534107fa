#include "image/compare_blocks.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace ajar {

namespace {
constexpr double kLargestZ = 37.0;

/// Mean of a block, with the variance of that mean and the degrees of freedom of this variance
/// (infinite if the variance is known).
struct BlockMean {
  double mean = 0;
  double variance = 0;
  double degrees_of_freedom = HUGE_VAL;
};

struct Difference {
  double value, error, freedom, z;
};

/// Part of an image: pixels of a block, one channel or (channel < 0) all.
struct Region {
  Box2i pixels;
  int channel;
};

template <typename Visit>
void for_each_value(const BlockGrid& grid, const Region& region, Visit visit) {
  const int first = std::max(region.channel, 0);
  const int last = region.channel < 0 ? grid.channels - 1 : region.channel;
  for (int y = region.pixels.min.y; y <= region.pixels.max.y; ++y) {
    for (int x = region.pixels.min.x; x <= region.pixels.max.x; ++x) {
      const std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.width) +
                                static_cast<std::size_t>(x);
      for (int c = first; c <= last; ++c) {
        visit(pixel * static_cast<std::size_t>(grid.channels) + static_cast<std::size_t>(c));
      }
    }
  }
}

double region_mean(std::span<const float> image, const BlockGrid& grid, const Region& region) {
  double sum = 0.0;
  double count = 0.0;
  for_each_value(grid, region, [&](std::size_t i) {
    sum += image[i];
    count += 1.0;
  });
  return sum / count;
}

BlockMean replicated_mean(const Replicates& replicates, const BlockGrid& grid,
                          const Region& region) {
  const auto count = static_cast<double>(replicates.size());
  std::vector<double> means;
  BlockMean result;
  for (const auto& image : replicates) {
    means.push_back(region_mean(image, grid, region));
    result.mean += means.back() / count;
  }
  for (const double m : means) result.variance += (m - result.mean) * (m - result.mean);
  result.variance /= count * (count - 1.0);
  result.degrees_of_freedom = count - 1.0;
  return result;
}

/// Mean over the blocks of an image whose pixels have independent errors; the channels of a pixel
/// are taken as fully correlated, for they see the same paths. `freedom`: degrees of freedom of
/// each value's variance, infinite if that is known. Empty variances are zero.
BlockMean reference_mean(std::span<const float> reference, std::span<const float> variance,
                         double freedom, const BlockGrid& grid, const Region& region) {
  BlockMean result;
  result.mean = region_mean(reference, grid, region);
  if (variance.empty()) return result;
  const int channels = region.channel < 0 ? grid.channels : 1;
  double count = 0.0;
  double squares = 0.0;
  double pixel_error = 0.0;
  int channels_seen = 0;
  for_each_value(grid, region, [&](std::size_t i) {
    count += 1.0;
    pixel_error += std::sqrt(variance[i]);
    if (++channels_seen < channels) return;
    const double pixel_variance = pixel_error * pixel_error;
    result.variance += pixel_variance;
    squares += pixel_variance * pixel_variance;
    pixel_error = 0.0;
    channels_seen = 0;
  });
  // Welch and Satterthwaite: of a sum of estimated variances.
  if (squares > 0.0) {
    result.degrees_of_freedom = freedom * result.variance * result.variance / squares;
  }
  result.variance /= count * count;
  return result;
}

Difference welch(const BlockMean& a, const BlockMean& b) {
  const double difference = a.mean - b.mean;
  // Images are stored in single precision: blocks without noise differ by rounding.
  const double rounding = 1e-6 * std::max(std::abs(a.mean), std::abs(b.mean));
  const double noise = a.variance + b.variance;
  const double error = std::sqrt(noise + rounding * rounding);
  if (std::isnan(difference) || std::isnan(error)) {
    return {difference, error, HUGE_VAL, kLargestZ};
  }
  if (error == 0.0) return {difference, error, HUGE_VAL, 0.0};
  const double freedom = noise > rounding * rounding
                             ? noise * noise /
                                   (a.variance * a.variance / a.degrees_of_freedom +
                                    b.variance * b.variance / b.degrees_of_freedom)
                             : HUGE_VAL;
  return {difference, error, freedom, normal_from_t(difference / error, freedom)};
}

double two_sided_p(double z) {
  return 2.0 * boost::math::cdf(boost::math::complement(boost::math::normal(), std::abs(z)));
}

/// Runs all tests; `mean_a` and `mean_b` give the mean of a region of either image.
template <typename MeanA, typename MeanB>
BlockComparison compare(const BlockGrid& grid, MeanA mean_a, MeanB mean_b) {
  BlockComparison result;
  std::vector<std::pair<double, double>> errors;  // with their degrees of freedom
  for (int y = 0; y < grid.height; y += grid.block) {
    for (int x = 0; x < grid.width; x += grid.block) {
      const Box2i block({x, y}, {std::min(x + grid.block, grid.width) - 1,
                                 std::min(y + grid.block, grid.height) - 1});
      for (int c = 0; c < grid.channels; ++c) {
        const Region region{block, c};
        const Difference d = welch(mean_a(region), mean_b(region));
        if (!std::isnan(d.error)) errors.emplace_back(d.error, d.freedom);
        if (++result.tests > 1 && std::abs(d.z) <= std::abs(result.worst_z)) continue;
        result.worst_block = block;
        result.worst_channel = c;
        result.worst_difference = d.value;
        result.worst_error = d.error;
        result.worst_z = d.z;
      }
    }
  }
  result.worst_p = two_sided_p(result.worst_z);
  // 1 − (1 − p)^n without cancellation.
  result.family_p = -std::expm1(result.tests * std::log1p(-std::min(result.worst_p, 1.0 - 1e-16)));

  const Region all{Box2i({0, 0}, {grid.width - 1, grid.height - 1}), -1};
  const BlockMean whole_b = mean_b(all);
  const Difference d = welch(mean_a(all), whole_b);
  result.mean_difference = d.value;
  result.mean_error = d.error;
  result.mean_freedom = d.freedom;
  result.mean_z = d.z;
  result.mean_relative_difference = d.value / whole_b.mean;
  if (errors.empty()) return result;
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  result.typical_error = middle->first;
  result.typical_freedom = middle->second;
  return result;
}

void check_size(std::span<const float> image, const BlockGrid& grid) {
  if (grid.width <= 0 || grid.height <= 0 || grid.channels <= 0 || grid.block <= 0 ||
      image.size() != static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height) *
                          static_cast<std::size_t>(grid.channels)) {
    throw std::invalid_argument("compare_blocks: an image does not fit the grid");
  }
}

void check_replicates(const Replicates& replicates, const BlockGrid& grid) {
  if (replicates.size() < 2) throw std::invalid_argument("compare_blocks: too few replicates");
  for (const auto& image : replicates) check_size(image, grid);
}
}  // namespace

double normal_from_t(double t, double degrees_of_freedom) {
  using boost::math::cdf;
  using boost::math::complement;
  const double size = std::abs(t);
  double z = size;
  // Beyond 1e8 degrees of freedom Student's distribution is the normal one.
  if (degrees_of_freedom < 1e8 && size > 0.0) {
    if (std::isinf(size)) return std::copysign(kLargestZ, t);
    const double tail = cdf(complement(boost::math::students_t(degrees_of_freedom), size));
    z = tail < 1e-300 ? kLargestZ : boost::math::quantile(complement(boost::math::normal(), tail));
  }
  return std::copysign(std::clamp(z, 0.0, kLargestZ), t);
}

bool BlockComparison::equal(double alpha) const {
  return family_p >= alpha && two_sided_p(mean_z) >= alpha;
}

BlockComparison compare_blocks(const Replicates& a, const Replicates& b, const BlockGrid& grid) {
  check_replicates(a, grid);
  check_replicates(b, grid);
  return compare(
      grid, [&](const Region& region) { return replicated_mean(a, grid, region); },
      [&](const Region& region) { return replicated_mean(b, grid, region); });
}

BlockComparison compare_blocks_to_reference(const Replicates& a, std::span<const float> reference,
                                            std::span<const float> reference_variance,
                                            const BlockGrid& grid) {
  check_replicates(a, grid);
  check_size(reference, grid);
  if (!reference_variance.empty()) check_size(reference_variance, grid);
  return compare(
      grid, [&](const Region& region) { return replicated_mean(a, grid, region); },
      [&](const Region& region) {
        return reference_mean(reference, reference_variance, HUGE_VAL, grid, region);
      });
}

BlockComparison compare_blocks_by_variance(std::span<const float> a,
                                           std::span<const float> a_variance,
                                           std::span<const float> b,
                                           std::span<const float> b_variance,
                                           const BlockGrid& grid) {
  for (const std::span<const float> image : {a, a_variance, b}) check_size(image, grid);
  if (!b_variance.empty()) check_size(b_variance, grid);
  return compare(
      grid, [&](const Region& region) { return reference_mean(a, a_variance, 1.0, grid, region); },
      [&](const Region& region) { return reference_mean(b, b_variance, 1.0, grid, region); });
}

double detectable_difference(double error, double freedom, double alpha, double power) {
  const auto quantile = [&](double upper_tail) {
    using boost::math::complement;
    return freedom < 1e8
               ? boost::math::quantile(complement(boost::math::students_t(freedom), upper_tail))
               : boost::math::quantile(complement(boost::math::normal(), upper_tail));
  };
  return (quantile(alpha / 2) + quantile(1 - power)) * error;
}

}  // namespace ajar
