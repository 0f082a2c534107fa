#pragma once
#include <cstddef>
#include <utility>
#include <vector>

namespace ajar {

/// Scale from the sums of a layer to pixel values: one over a number of samples, as a rule equal
/// for all pixels. Methods with a scale per pixel (density of samples, radius of gathering,
/// brightness of a tile) have a factor for each.
struct DevelopScale {
  double factor = 0.0;          ///< common to all pixels
  std::vector<float> pixels{};  ///< times that of each, row by row over the crop; empty: 1

  DevelopScale() = default;
  DevelopScale(double every_pixel) : factor(every_pixel) {}
  explicit DevelopScale(std::vector<float> each_pixel)
      : factor(1.0), pixels(std::move(each_pixel)) {}

  double at(std::size_t pixel) const {
    return pixels.empty() ? factor : factor * static_cast<double>(pixels[pixel]);
  }
};

/// Scale of the sum of two films with scales of their own: numbers of samples add up. Scales by
/// pixel must be of one size.
DevelopScale scale_of_sum(const DevelopScale& a, const DevelopScale& b);

}  // namespace ajar
