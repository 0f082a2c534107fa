#pragma once
#include <cstdint>
#include <functional>
#include <string>

#include "mcmc/moments.h"
#include "support/render.h"

namespace ajar::test {

/// Mean of the picture as a function of the seed. The scene must outlive it.
std::function<double(std::uint64_t seed)> mean_of_seed(const Scene& scene, RenderOptions options);
/// Means of pictures of seeds that `expect_mean_over_seeds` does not have.
Moments means_of_other_seeds(const Scene& scene, const RenderOptions& options, int renders);

/// An expectation, the standard error with which it is known, and the deviation to be noticed.
struct ExpectedMean {
  double value;
  double standard_error;
  double effect;
};

/// Claims that the mean of `value(seed)` is as expected, over seeds from 1. A look at a third of
/// `seeds` ends it if a deviation by the effect is 2.4 standard errors away, which it seems to be
/// by mistake once in 120 times. Otherwise the mean of all of them has to be within 5 standard
/// errors, and these less than the effect.
void expect_mean_over_seeds(const ExpectedMean& expected, int seeds,
                            const std::function<double(std::uint64_t seed)>& value,
                            const std::string& name);

}  // namespace ajar::test
