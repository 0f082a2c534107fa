#pragma once
#include <cstddef>
#include <utility>
#include <vector>

namespace ajar {

/// What turns the sums of a layer into pixel values: one over a number of samples, as a rule the
/// same for all pixels. Methods that bring more of them to some pixels than to others, or scale
/// what they bring by something of the pixel (its radius of gathering, the brightness of its tile),
/// have a factor for each.
struct DevelopScale {
  double factor = 0.0;          ///< of every pixel
  std::vector<float> pixels{};  ///< times that of each, row by row over the crop; empty: 1

  DevelopScale() = default;
  DevelopScale(double every_pixel) : factor(every_pixel) {}
  explicit DevelopScale(std::vector<float> each_pixel)
      : factor(1.0), pixels(std::move(each_pixel)) {}

  double at(std::size_t pixel) const {
    return pixels.empty() ? factor : factor * static_cast<double>(pixels[pixel]);
  }
};

/// That of the sum of two films, each of which has its own: numbers of samples add up. Those that
/// differ by pixel must be of one size.
DevelopScale scale_of_sum(const DevelopScale& a, const DevelopScale& b);

}  // namespace ajar
