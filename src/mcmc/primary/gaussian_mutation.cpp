#include "mcmc/primary/gaussian_mutation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "core/vector.h"
#include "mcmc/counter_random.h"
#include "mcmc/primary/fast_math.h"
#include "mcmc/primary/unit_grid.h"

namespace ajar {

namespace {
/// A wrapped normal distribution this wide differs from the uniform by 2·exp(−2π²σ²) < 1e-137, so a
/// wider one is the same in every respect. Keeps steps within the range of the grid's addition.
constexpr float kWidest = 4.F;
}  // namespace

GaussianMutation::GaussianMutation(double sigma) : sigma_(sigma) {
  if (!(sigma > 0.0 && std::isfinite(sigma))) {
    throw std::invalid_argument("gaussian mutation needs a finite sigma > 0");
  }
}

void GaussianMutation::perturb(std::span<float> numbers, std::span<const float> scales,
                               double steps, std::uint64_t key) const {
  const auto sigma = static_cast<float>(sigma_ * std::sqrt(steps));
  // Box & Muller 1958, in batches that fill the lanes of a processor. The angle is uniform within a
  // quarter turn around the x axis; one bit swaps the axes and one picks a side.
  constexpr std::size_t kPairs = 8;
  for (std::size_t first = 0; first + 1 < numbers.size(); first += 2 * kPairs) {
    const std::size_t pairs = std::min(kPairs, (numbers.size() - first) / 2);
    std::array<std::uint32_t, kPairs> high{};
    std::array<std::uint32_t, kPairs> low{};
    for (std::size_t i = 0; i < pairs; ++i) {
      const std::uint64_t bits = counter_bits(key, first / 2 + i);
      high[i] = static_cast<std::uint32_t>(bits >> 32U);
      low[i] = static_cast<std::uint32_t>(bits);
    }
    std::array<float, kPairs> x;
    std::array<float, kPairs> y;
    for (std::size_t i = 0; i < kPairs; ++i) {
      // 31 bits, since a signed conversion is one instruction; half a cell keeps it off zero.
      const float u =
          (static_cast<float>(static_cast<std::int32_t>(high[i] >> 1U)) + 0.5F) * 0x1p-31F;
      const float radius = std::sqrt(std::max(0.F, -2.F * fast_log(u)));
      // Half a cell here makes the distribution symmetric to the bit.
      const auto place = static_cast<float>(static_cast<std::int32_t>(low[i] >> 8U) - 0x800000);
      const float angle = (place + 0.5F) * (0x1p-25F * kPi);
      const float side = (low[i] & 1U) != 0 ? radius : -radius;
      const float along = side * fast_cos(angle);
      const float across = radius * fast_sin(angle);
      const bool swap = (low[i] & 2U) != 0;
      x[i] = swap ? across : along;
      y[i] = swap ? along : across;
    }
    for (std::size_t i = 0; i < pairs; ++i) {
      const std::size_t k = first + 2 * i;
      const float sigma_x = std::min(sigma * scales[k], kWidest);
      const float sigma_y = std::min(sigma * scales[k + 1], kWidest);
      numbers[k] = add_on_unit_circle(numbers[k], sigma_x * x[i]);
      numbers[k + 1] = add_on_unit_circle(numbers[k + 1], sigma_y * y[i]);
    }
  }
}

double GaussianMutation::density(float from, float to, float scale) const {
  const double sigma = std::min(sigma_ * double{scale}, double{kWidest});
  const double difference = double{to} - double{from};
  const auto turns = static_cast<int>(std::ceil(8.0 * sigma)) + 1;
  double sum = 0.0;
  for (int turn = -turns; turn <= turns; ++turn) {
    const double x = (difference + turn) / sigma;
    sum += std::exp(-0.5 * x * x);
  }
  return sum / (sigma * std::sqrt(2.0 * double{kPi}));
}

}  // namespace ajar
