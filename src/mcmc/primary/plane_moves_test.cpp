#include "mcmc/primary/plane_moves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "mcmc/primary/gaussian_mutation.h"
#include "mcmc/primary/kelemen_mutation.h"
#include "mcmc/primary/primary_runner.h"
#include "mcmc/primary/unit_grid.h"
#include "mcmc/testing/toy_target.h"
#include "mcmc/testing/two_rooms.h"
#include "scene/testing/statistics.h"

namespace ajar {
namespace {

using testing::bias_of;
using testing::Nowhere;
using testing::PlaneBias;
using testing::Toy;
using testing::ToyTarget;
using testing::ToyValue;
using testing::TwoRooms;

struct RuleCase {
  const char* name;
  PlaneRule rule;
};
std::vector<RuleCase> exact_rules() {
  PlaneRule adaptive;
  adaptive.adaptive = true;
  PlaneRule neighbours;
  neighbours.neighbours = true;
  neighbours.neighbour_visits = 50.0;
  PlaneRule fusion = adaptive;
  fusion.neighbours = true;
  // Chosen so that all three kinds of step occur.
  fusion.neighbour_visits = 60.0;
  return {{"adaptive", adaptive}, {"slemmlt", neighbours}, {"fusion", fusion}};
}

TEST(RasterGrid, EveryPlaceOfAPixelIsInIt) {
  // The first and last column are covered in part, one by a sliver.
  const RasterGrid grid({0.75F, 0.999999F}, {5.5F, 7.F}, {7, 8});
  double whole = 0.0;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 7; ++x) {
      whole += grid.area({x, y});
      for (const std::uint64_t bits : {0ULL, 1ULL << 63U, ~0ULL}) {
        EXPECT_EQ(grid.pixel(grid.place({x, y}, bits, ~bits)), Vec2i(x, y));
      }
    }
  }
  EXPECT_NEAR(whole, 1.0, 1e-12);
  EXPECT_NEAR(grid.area({3, 3}), 1.0 / (5.5 * 7.0), 1e-6);
  EXPECT_NEAR(grid.area({0, 3}), 0.25 / (5.5 * 7.0), 1e-6);
  EXPECT_EQ(grid.neighbour({0, 0}, {-1, -1}), Vec2i(6, 7));
}

TEST(PlaneMoves, StepsFollowTheirDensity) {
  // 200,000 steps: 1 % that go to the wrong pixel among their 72 would be several hundred in the
  // statistic.
  const TwoRooms rooms;
  for (const RuleCase& c : exact_rules()) {
    const PlaneMoves moves = rooms.moves(c.rule);
    for (const Vec2& from : {Vec2(0.2F, 0.4F), Vec2(0.7F, 0.4F), Vec2(0.54F, 0.02F)}) {
      SCOPED_TRACE(std::string(c.name) + " from " + std::to_string(from.x));
      constexpr int kSteps = 200000;
      constexpr int kParts = 16;
      std::vector<double> counts(TwoRooms::kPixels, 0.0);
      std::vector<double> expected(TwoRooms::kPixels, 0.0);
      for (int i = 0; i < kSteps; ++i) {
        const std::uint64_t key = hash_numbers(3, static_cast<std::uint64_t>(i));
        std::array<float, 2> plain{from.x, from.y};
        const std::array<float, 2> ones{1.F, 1.F};
        rooms.mutation.perturb(plain, ones, 1, key);
        const Vec2 to = moves.move(from, key).value_or(Vec2(plain[0], plain[1]));
        ++counts[rooms.grid.index(rooms.grid.pixel(to))];
      }
      for (int y = 0; y < TwoRooms::kRows * kParts; ++y) {
        for (int x = 0; x < TwoRooms::kColumns * kParts; ++x) {
          const Vec2 to((static_cast<float>(x) + 0.5F) / (TwoRooms::kColumns * kParts),
                        (static_cast<float>(y) + 0.5F) / (TwoRooms::kRows * kParts));
          expected[rooms.grid.index(rooms.grid.pixel(to))] +=
              moves.density(from, to) * kSteps / (TwoRooms::kPixels * kParts * kParts);
        }
      }
      testing::expect_fits(counts, expected);
    }
  }
}

TEST(PlaneMoves, BalanceIsDetailed) {
  // With a uniform target: the flow from x to y is that from y to x.
  const TwoRooms rooms;
  for (const RuleCase& c : exact_rules()) {
    const PlaneMoves moves = rooms.moves(c.rule);
    Rng rng(5);
    int uneven = 0;
    for (int i = 0; i < 20000; ++i) {
      const Vec2 x(rng.next(), rng.next());
      const Vec2 y(add_on_unit_circle(x.x, 0.3F * rng.next()), rng.next());
      const double forth = moves.density(x, y) * std::min(1.0, std::exp(moves.log_ratio(x, y)));
      const double back = moves.density(y, x) * std::min(1.0, std::exp(moves.log_ratio(y, x)));
      EXPECT_NEAR(forth, back, 1e-9 * (forth + back) + 1e-200) << c.name;
      if (moves.log_ratio(x, y) != 0.0) ++uneven;
    }
    EXPECT_GT(uneven, 100) << c.name;
  }
}

TEST(PlaneMoves, StepSizesFollowTheVarianceOfTheVisits) {
  const RasterGrid grid({0.F, 0.F}, {5.F, 5.F}, {5, 5});
  const GaussianMutation mutation;
  PlaneRule rule;
  rule.adaptive = true;
  const auto factor = [&](float visits, float other) {
    std::vector<PixelVisits> pixels(25, {visits, 0.F});
    pixels[12].visits = other;
    return PlaneMoves(grid, rule, pixels, mutation).factor({0.5F, 0.5F});
  };
  EXPECT_EQ(factor(100.F, 100.F), 1.F) << "λ2·0 is not above 1";
  EXPECT_EQ(factor(40.F, 49.F), 1.F) << "too few visits to tell";
  // One of nine differs by d: the variance is d²·8/81.
  EXPECT_NEAR(factor(100.F, 109.F), 0.7 * 8.0, 1e-5);
  EXPECT_EQ(factor(100.F, 118.F), 1.F) << "between k2 and k1";
  EXPECT_NEAR(factor(100.F, 136.F), 23.0 / 128.0, 1e-6);
  EXPECT_EQ(factor(100.F, 10000.F), 1.F / 64.F);
}

TEST(PlaneMoves, ExactRulesKeepTheDistributionToTheLastDigits) {
  const TwoRooms rooms;
  for (const RuleCase& c : exact_rules()) {
    for (const double large : {0.02, 0.3}) {
      const PlaneBias bias = bias_of(rooms, c.rule, large);
      EXPECT_LT(bias.pixel, 1e-11) << c.name;
    }
  }
}

TEST(PlaneMoves, PublishedRulesDoNotKeepTheDistribution) {
  // The table of docs/notebook/mutations.md.
  struct Expected {
    double large;
    double left_half;
    double pixel;
  };
  const std::vector<std::vector<Expected>> expected = {
      {{0.02, -0.26406803, 0.77054566}, {0.3, -0.16218443, 0.43212256}},
      {{0.02, -0.04543852, 3.75695310}, {0.3, -0.03452178, 2.37784833}},
      {{0.02, -0.56492863, 4.61401527}, {0.3, -0.16797942, 1.69074994}}};
  const TwoRooms rooms;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    RuleCase c = exact_rules()[i];
    c.rule.published = true;
    for (const Expected& e : expected[i]) {
      SCOPED_TRACE(std::string(c.name) + ", large steps " + std::to_string(e.large));
      const PlaneBias bias = bias_of(rooms, c.rule, e.large);
      EXPECT_NEAR(bias.left_half, e.left_half, 1e-6);
      EXPECT_NEAR(bias.pixel, e.pixel, 1e-6);
    }
  }
}

/// Largest relative error of a state's probability for a chain whose states use the raster numbers
/// or do not (a second number says which, drawn anew in every step), by its transition matrix.
/// `by_both`: they move by the map if both states use them; otherwise, if the proposal does.
double error_of_use(const PlaneRule& rule, bool by_both) {
  constexpr std::size_t n = TwoRooms::kPixels;
  const TwoRooms rooms;
  const PlaneMoves moves = rooms.moves(rule);
  const auto brightness = [&](std::size_t state) { return state < n ? rooms.target[state] : 0.7; };
  std::vector<std::vector<double>> matrix(2 * n, std::vector<double>(2 * n, 0.0));
  for (std::size_t from = 0; from < 2 * n; ++from) {
    double away = 0.0;
    for (std::size_t to = 0; to < 2 * n; ++to) {
      if (to == from) continue;
      const Vec2 x = TwoRooms::center(from % n);
      const Vec2 y = TwoRooms::center(to % n);
      const bool both = from < n && to < n;
      const double density =
          both || (!by_both && to < n)
              ? moves.density(x, y)
              : rooms.mutation.density(x.x, y.x, 1.F) * rooms.mutation.density(x.y, y.y, 1.F);
      const double ratio = both ? moves.log_ratio(x, y) : 0.0;
      const double a = std::min(1.0, brightness(to) / brightness(from) * std::exp(ratio));
      matrix[from][to] = 0.5 * density / n * a;
      away += matrix[from][to];
    }
    matrix[from][from] = 1.0 - away;
  }
  std::vector<double> now(2 * n, 0.5 / n);
  for (int step = 0; step < 3000; ++step) {
    std::vector<double> next(2 * n, 0.0);
    for (std::size_t from = 0; from < 2 * n; ++from) {
      for (std::size_t to = 0; to < 2 * n; ++to) next[to] += now[from] * matrix[from][to];
    }
    now = std::move(next);
  }
  double worst = 0.0;
  for (std::size_t i = 0; i < 2 * n; ++i) {
    const double error = now[i] * (rooms.sum + 0.7 * n) / brightness(i) - 1.0;
    EXPECT_TRUE(std::isfinite(error));
    worst = std::max(worst, std::abs(error));
  }
  return worst;
}

TEST(PlaneMoves, RasterNumbersMoveByTheMapOnlyIfBothStatesUseThem) {
  for (RuleCase c : exact_rules()) {
    // Points are too coarse for steps much shorter than a pixel.
    c.rule.shorten = 1e9;
    EXPECT_LT(error_of_use(c.rule, true), 1e-10) << c.name;
    EXPECT_GT(error_of_use(c.rule, false), 0.04) << c.name;
  }
}

/// Half of the states are placed by the raster numbers, the others do not use them. Bins are
/// squares of 6 × 6, and the rest.
Toy placed_or_not() {
  constexpr int kSide = 6;
  const Toy step = testing::step();
  Toy toy{"placed or not",
          [step](SampleSource& numbers) {
            if (numbers.get(testing::kChoice) < 0.5F) return step.function(numbers);
            const float v = numbers.get(testing::kInner);
            return ToyValue{v < 0.3F ? 1.0 : 0.2, kSide * kSide};
          },
          1.0,
          0.5 * (0.525 + 0.44),
          {}};
  for (const double fraction : step.fractions) {
    toy.fractions.push_back(fraction * 0.5 * 0.525 / toy.mean);
  }
  toy.fractions.push_back(0.22 / toy.mean);
  return toy;
}

constexpr std::uint64_t kChains = 40000;

std::vector<double> expected_states(const Toy& toy) {
  std::vector<double> expected;
  for (const double fraction : toy.fractions) expected.push_back(fraction * kChains);
  return expected;
}

/// Where chains that start in the target's distribution are after twenty steps, made in two runs
/// (see chain_stationarity_test.cpp).
std::vector<double> last_states(const Toy& toy, const Mutation& mutation, const PlaneRule& rule,
                                const PrimarySettings& settings) {
  const TwoRooms rooms;
  const PlaneMoves moves(rooms.grid, rule, rooms.pixels, mutation);
  ToyTarget target(toy.function);
  PrimaryRunner runner(settings, mutation, testing::kToyShape, target, &moves);
  Nowhere nowhere;
  std::vector<double> counts(toy.fractions.size(), 0.0);
  for (std::uint64_t i = 0; i < kChains; ++i) {
    PrimaryChain chain = testing::exact_start(toy, 11, i);
    runner.run(chain, 9, nowhere);
    runner.run(chain, 11, nowhere);
    ReplaySource replay(chain.numbers);
    ++counts[static_cast<std::size_t>(toy.function(replay).bin)];
  }
  return counts;
}

TEST(PlaneMoves, ChainsStayInTheirDistribution) {
  PrimarySettings settings;
  settings.probabilities = {0.1, 0.2, 0.2};
  settings.connection = {true, false};
  for (const RuleCase& c : exact_rules()) {
    for (const Toy& toy : {testing::step(), placed_or_not()}) {
      SCOPED_TRACE(std::string(c.name) + ", " + toy.name);
      testing::expect_fits(last_states(toy, GaussianMutation(0.08), c.rule, settings),
                           expected_states(toy));
    }
  }
  const PlaneRule fusion = exact_rules().back().rule;
  for (const Toy& toy : {testing::product(), placed_or_not()}) {
    SCOPED_TRACE(std::string("kelemen, ") + toy.name);
    testing::expect_fits(last_states(toy, KelemenMutation(0.01, 0.2), fusion, settings),
                         expected_states(toy));
  }
}

TEST(PlaneMoves, ChainsStayInTheirDistributionWithStepsOfEveryKind) {
  PrimarySettings settings;
  settings.probabilities = {0.1, 0.1, 0.1, 0.4, 0.3};
  settings.tries = 3;
  for (const RuleCase& c : exact_rules()) {
    for (const Toy& toy : {testing::step(), placed_or_not()}) {
      SCOPED_TRACE(std::string(c.name) + ", " + toy.name);
      testing::expect_fits(last_states(toy, GaussianMutation(0.08), c.rule, settings),
                           expected_states(toy));
    }
  }
}

TEST(PlaneMoves, PublishedChainsLeaveTheirDistribution) {
  // Power of the test before. 40 cells of χ² vary by 9.
  PrimarySettings settings;
  settings.probabilities = {0.1, 0.2, 0.2};
  const Toy toy = testing::step();
  for (RuleCase c : exact_rules()) {
    c.rule.published = true;
    const auto counts = last_states(toy, GaussianMutation(0.08), c.rule, settings);
    const auto expected = expected_states(toy);
    double statistic = 0.0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      statistic += (counts[i] - expected[i]) * (counts[i] - expected[i]) / expected[i];
    }
    EXPECT_GT(statistic, 500.0) << c.name;
  }
}

}  // namespace
}  // namespace ajar
