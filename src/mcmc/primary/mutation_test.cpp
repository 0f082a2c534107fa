#include "mcmc/primary/mutation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "core/error.h"
#include "core/random.h"
#include "mcmc/primary/gaussian_mutation.h"
#include "mcmc/primary/kelemen_mutation.h"
#include "mcmc/primary/make_mutation.h"
#include "mcmc/primary/step_sizes.h"
#include "mcmc/primary/unit_grid.h"
#include "scene/testing/statistics.h"

namespace ajar {
namespace {

constexpr int kCells = 2048;

struct Case {
  std::unique_ptr<Mutation> mutation;
  float scale;
};
std::vector<Case> cases() {
  std::vector<Case> result;
  result.push_back({std::make_unique<GaussianMutation>(), 1.F});
  result.push_back({std::make_unique<GaussianMutation>(0.2), 2.F});
  result.push_back({std::make_unique<KelemenMutation>(), 1.F});
  result.push_back({std::make_unique<KelemenMutation>(), 8.F});
  result.push_back({std::make_unique<KelemenMutation>(0.05, 0.9), 1.F});
  return result;
}

/// Probability to get from the middle of `from_cell` into each cell, by integration.
std::vector<double> cell_probabilities(const Case& c, float from) {
  constexpr int kParts = 128;
  std::vector<double> result(kCells, 0.0);
  for (int i = 0; i < kCells * kParts; ++i) {
    const auto to = static_cast<float>((i + 0.5) / (kCells * kParts));
    result[static_cast<std::size_t>(i / kParts)] +=
        c.mutation->density(from, to, c.scale) / (kCells * kParts);
  }
  return result;
}

constexpr int kBlocks = 40000;

/// Counts where numbers of each slot go after `calls` calls for `steps` steps each. 400,000
/// samples: 1 % of them in the wrong half of the distribution would be 6 standard errors.
std::vector<double> sample(const Case& c, float from, double steps, int calls = 1) {
  StepSizes::Scales scales;
  scales.fill(c.scale);
  std::vector<double> counts(kCells, 0.0);
  for (int i = 0; i < kBlocks; ++i) {
    std::array<float, kBlockSize> block;
    block.fill(from);
    for (int call = 0; call < calls; ++call) {
      c.mutation->perturb(
          block, scales, steps,
          hash_numbers(static_cast<std::uint64_t>(64.0 * steps), static_cast<std::uint64_t>(call),
                       static_cast<std::uint64_t>(i)));
    }
    for (const float u : block) {
      EXPECT_GE(u, 0.F);
      EXPECT_LT(u, 1.F);
      ++counts[std::min(static_cast<std::size_t>(u * kCells), std::size_t{kCells - 1})];
    }
  }
  return counts;
}

TEST(Mutation, SamplesFollowTheirDensity) {
  for (const Case& c : cases()) {
    for (const float from : {0.F, 0.003F, 0.51F, kOneMinusEpsilon}) {
      SCOPED_TRACE(std::string(c.mutation->name()) + " × " + std::to_string(c.scale) + " from " +
                   std::to_string(from));
      std::vector<double> expected = cell_probabilities(c, from);
      double sum = 0.0;
      for (double& e : expected) {
        sum += e;
        e *= double{kBlocks} * kBlockSize;
      }
      EXPECT_NEAR(sum, 1.0, 2e-3);
      testing::expect_fits(sample(c, from, 1), expected);
    }
  }
}

TEST(Mutation, PendingStepsAreThatManySingleSteps) {
  for (const Case& c : cases()) {
    for (const int steps : {2, 7}) {
      SCOPED_TRACE(std::string(c.mutation->name()) + " × " + std::to_string(c.scale) + ", " +
                   std::to_string(steps) + " steps");
      // Two samples of equal size: each cell's difference has the variance of its sum.
      const auto at_once = sample(c, 0.25F, steps);
      const auto one_by_one = sample(c, 0.25F, 1, steps);
      std::vector<double> expected;
      std::vector<double> shifted;
      for (std::size_t i = 0; i < kCells; ++i) {
        expected.push_back(at_once[i] + one_by_one[i]);
        shifted.push_back(expected.back() + at_once[i] - one_by_one[i]);
      }
      testing::expect_fits(shifted, expected);
    }
  }
}

TEST(Mutation, GaussianStepsAddUp) {
  // n steps at once have the density of one step with σ·√n; 10⁹ steps are uniform.
  const GaussianMutation one(0.01);
  for (const auto& [steps, sigma] : {std::pair{9U, 0.03}, {400U, 0.2}, {1000000000U, 100.0}}) {
    const Case many{std::make_unique<GaussianMutation>(sigma), 1.F};
    std::vector<double> expected = cell_probabilities(many, 0.9F);
    for (double& e : expected) e *= double{kBlocks} * kBlockSize;
    testing::expect_fits(sample({std::make_unique<GaussianMutation>(0.01), 1.F}, 0.9F, steps),
                         expected);
  }
}

TEST(Mutation, GaussianStepsDivide) {
  // A 1/64 of a step has the density of one with an eighth of σ, and 64 of them that of a whole
  // one.
  const Case whole{std::make_unique<GaussianMutation>(0.16), 1.F};
  const Case eighth{std::make_unique<GaussianMutation>(0.02), 1.F};
  const auto expected = [](const Case& c) {
    std::vector<double> counts = cell_probabilities(c, 0.9F);
    for (double& e : counts) e *= double{kBlocks} * kBlockSize;
    return counts;
  };
  testing::expect_fits(sample(whole, 0.9F, 1.0 / 64), expected(eighth));
  testing::expect_fits(sample(whole, 0.9F, 1.0 / 64, 64), expected(whole));
  EXPECT_TRUE(whole.mutation->divisible());
  EXPECT_FALSE(KelemenMutation().divisible());
}

TEST(Mutation, DensitiesAreSymmetric) {
  Rng rng(5);
  for (const Case& c : cases()) {
    for (int i = 0; i < 2000; ++i) {
      const float from = rng.next();
      const float to = i % 2 == 0 ? rng.next() : add_on_unit_circle(from, 0.04F * rng.next());
      const double forth = c.mutation->density(from, to, c.scale);
      EXPECT_NEAR(c.mutation->density(to, from, c.scale), forth, 1e-12 * forth);
    }
    const std::array<float, 2> a{0.1F, 0.2F};
    EXPECT_EQ(c.mutation->log_ratio(a, a, a), 0.0);
  }
}

TEST(Mutation, NumbersOfABlockMoveIndependently) {
  // 40,000 blocks: a correlation of 0.025 between two slots is 5 standard errors.
  for (const Case& c : cases()) {
    if (c.scale * 0.1F > 0.15F)
      continue;  // steps around the circle have no correlation to speak of
    StepSizes::Scales scales;
    scales.fill(c.scale);
    std::array<std::array<double, kBlockSize>, kBlockSize> products{};
    for (int i = 0; i < kBlocks; ++i) {
      std::array<float, kBlockSize> block;
      block.fill(0.5F);
      c.mutation->perturb(block, scales, 1, hash_numbers(9, static_cast<std::uint64_t>(i)));
      for (std::size_t j = 0; j < kBlockSize; ++j) {
        for (std::size_t k = 0; k < kBlockSize; ++k) {
          products[j][k] += (double{block[j]} - 0.5) * (double{block[k]} - 0.5);
        }
      }
    }
    for (std::size_t j = 0; j < kBlockSize; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        EXPECT_LT(std::abs(products[j][k]), 0.025 * std::sqrt(products[j][j] * products[k][k]));
      }
    }
  }
}

TEST(Mutation, ScaleZeroHoldsANumber) {
  for (const Case& c : cases()) {
    StepSizes::Scales scales = StepSizes::ones();
    scales[3] = 0.F;
    std::array<float, kBlockSize> block;
    block.fill(0.25F);
    c.mutation->perturb(block, scales, 5, 1);
    EXPECT_EQ(block[3], 0.25F);
    EXPECT_NE(block[2], 0.25F);
  }
}

TEST(Mutation, IsMadeByName) {
  for (const std::string& name : mutation_names()) {
    EXPECT_EQ(make_mutation(name, 0.01)->name(), name);
  }
  EXPECT_THROW(make_mutation("gausian", 0.01), UsageError);
  EXPECT_THROW(GaussianMutation(0.0), std::invalid_argument);
  EXPECT_THROW(KelemenMutation(0.1, 0.01), std::invalid_argument);
}

}  // namespace
}  // namespace ajar
