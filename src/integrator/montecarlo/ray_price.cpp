#include "integrator/montecarlo/ray_price.h"

#include <cmath>
#include <stdexcept>

#include "core/archive.h"
#include "image/visible_error.h"

namespace ajar {

void RayPrice::adjust(std::span<const double> variance, double rays) {
  // Mean of visible errors: fireflies, and the border of a lamp, say little of all other pixels.
  double sum = 0.0;
  for (const double of_pixel : variance) sum += visible_error(of_pixel);
  const double price = std::sqrt(variance_of(sum / static_cast<double>(variance.size())) / rays);
  if (price > 0.0 && std::isfinite(price)) price_ = price;
}

void RayPrice::save_state(OutputArchive& archive) const { archive(price_); }

void RayPrice::load_state(InputArchive& archive) {
  double price = 0.0;
  archive(price);
  if (const auto single = static_cast<float>(price); !(single > 0.F && std::isfinite(single))) {
    throw std::runtime_error("a price of rays that cannot be");
  }
  price_ = price;
}

}  // namespace ajar
