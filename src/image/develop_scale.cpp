#include "image/develop_scale.h"

#include <algorithm>

namespace ajar {

namespace {
/// 0: no samples.
double of_both(double a, double b) {
  const double samples = (a > 0.0 ? 1.0 / a : 0.0) + (b > 0.0 ? 1.0 / b : 0.0);
  return samples > 0.0 ? 1.0 / samples : 0.0;
}
}  // namespace

DevelopScale scale_of_sum(const DevelopScale& a, const DevelopScale& b) {
  if (a.pixels.empty() && b.pixels.empty()) return of_both(a.factor, b.factor);
  std::vector<float> pixels(std::max(a.pixels.size(), b.pixels.size()));
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    pixels[i] = static_cast<float>(of_both(a.at(i), b.at(i)));
  }
  return DevelopScale(std::move(pixels));
}

}  // namespace ajar
