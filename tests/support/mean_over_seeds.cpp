#include "support/mean_over_seeds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace ajar::test {

std::function<double(std::uint64_t seed)> mean_of_seed(const Scene& scene, RenderOptions options) {
  return [&scene, own = std::move(options)](std::uint64_t seed) mutable {
    own.seed = seed;
    return render(scene, own).mean();
  };
}

Moments means_of_other_seeds(const Scene& scene, const RenderOptions& options, int renders) {
  constexpr std::uint64_t kFirst = 1001;
  const auto mean = mean_of_seed(scene, options);
  Moments means;
  for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(renders); ++i)
    means.add(mean(kFirst + i));
  return means;
}

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
