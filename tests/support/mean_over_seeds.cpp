#include "support/mean_over_seeds.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mcmc/moments.h"

namespace ajar::test {

void expect_mean_over_seeds(const ExpectedMean& expected, int seeds,
                            const std::function<double(std::uint64_t seed)>& value,
                            const std::string& name) {
  Moments values;
  const auto deviation = [&] { return std::abs(values.mean() - expected.value); };
  const auto error = [&] { return std::hypot(values.standard_error(), expected.standard_error); };
  for (int seed = 1; seed <= seeds; ++seed) {
    values.add(value(static_cast<std::uint64_t>(seed)));
    if (seed == seeds / 3 && deviation() + 2.4 * error() < expected.effect) return;
  }
  EXPECT_LT(deviation(), 5.0 * error()) << name << ": " << values.mean();
  EXPECT_LT(5.0 * error(), expected.effect) << name << ": too noisy to notice what it should";
}

}  // namespace ajar::test
