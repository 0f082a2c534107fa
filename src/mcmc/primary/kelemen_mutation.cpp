#include "mcmc/primary/kelemen_mutation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "mcmc/counter_random.h"
#include "mcmc/primary/fast_math.h"
#include "mcmc/primary/unit_grid.h"

namespace ajar {

KelemenMutation::KelemenMutation(double shortest, double longest)
    : shortest_(shortest),
      longest_(longest),
      octaves_(static_cast<float>(std::log2(longest / shortest))) {
  // Steps shorter than a cell of the grid are none.
  if (!(shortest >= 0x1p-24 && shortest < longest && longest <= 1.0)) {
    throw std::invalid_argument("kelemen mutation needs 2^-24 <= shortest < longest <= 1");
  }
}

void KelemenMutation::perturb(std::span<float> numbers, std::span<const float> scales, double steps,
                              std::uint64_t key) const {
  // Sums of these steps have no closed form, so pending steps are made one after another. All in
  // all that costs no more than mutating the block in every accepted step would have. In batches
  // that fill the lanes of a processor.
  constexpr std::size_t kLanes = 16;
  const auto longest = static_cast<float>(longest_);
  std::uint64_t counter = 0;
  const auto whole = static_cast<std::uint64_t>(steps);
  for (std::uint64_t step = 0; step < whole; ++step) {
    for (std::size_t first = 0; first < numbers.size(); first += kLanes) {
      const std::size_t count = std::min(kLanes, numbers.size() - first);
      std::array<std::uint32_t, kLanes> bits{};
      for (std::size_t i = 0; i + 1 < count; i += 2) {
        const std::uint64_t pair = counter_bits(key, counter++);
        bits[i] = static_cast<std::uint32_t>(pair >> 32U);
        bits[i + 1] = static_cast<std::uint32_t>(pair);
      }
      std::array<float, kLanes> distances;
      for (std::size_t i = 0; i < kLanes; ++i) {
        const auto xi = static_cast<float>(static_cast<std::int32_t>(bits[i] >> 8U)) * 0x1p-24F;
        const float length = longest * fast_exp2(-octaves_ * xi);
        // The lowest bit is none of those that made the length.
        distances[i] = (bits[i] & 1U) != 0 ? length : -length;
      }
      for (std::size_t i = 0; i < count; ++i) {
        numbers[first + i] =
            add_on_unit_circle(numbers[first + i], scales[first + i] * distances[i]);
      }
    }
  }
}

double KelemenMutation::density(float from, float to, float scale) const {
  // Uniform in the logarithm of the length; summed over all lengths that lead to the same number.
  const double shortest = shortest_ * double{scale};
  const double longest = longest_ * double{scale};
  const double difference = double{to} - double{from};
  const auto turns = static_cast<int>(std::ceil(longest)) + 1;
  double sum = 0.0;
  for (int turn = -turns; turn <= turns; ++turn) {
    const double length = std::abs(difference + turn);
    if (length >= shortest && length <= longest)
      sum += 0.5 / (length * std::log(longest / shortest));
  }
  return sum;
}

}  // namespace ajar
