#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "mcmc/primary/gaussian_mutation.h"
#include "mcmc/primary/kelemen_mutation.h"
#include "mcmc/primary/primary_runner.h"
#include "mcmc/testing/toy_target.h"
#include "scene/testing/statistics.h"

/// A chain that starts in its target's distribution must stay there, whatever steps it makes: many
/// short independent chains, counted at their last state. No autocorrelation has to be estimated.
namespace ajar {
namespace {

using testing::Nowhere;
using testing::Toy;
using testing::ToyTarget;

/// Chi-square of the last states. With 40,000 chains, a bin of 5 % that gains or loses 10 % of its
/// share alone adds 20 to the statistic, one of 20 %, 80.
void expect_stationary(const Toy& toy, const Mutation& mutation, const PrimarySettings& settings,
                       std::uint64_t steps, std::uint64_t chains = 40000) {
  ToyTarget target(toy.function);
  PrimaryRunner runner(settings, mutation, testing::kToyShape, target);
  Nowhere nowhere;
  std::vector<double> counts(toy.fractions.size(), 0.0);
  std::vector<double> expected;
  for (const double fraction : toy.fractions) {
    expected.push_back(fraction * static_cast<double>(chains));
  }
  ChainStatistics statistics;
  for (std::uint64_t i = 0; i < chains; ++i) {
    PrimaryChain chain = testing::exact_start(toy, 11, i);
    statistics += runner.run(chain, steps, nowhere);
    ReplaySource replay(chain.numbers);
    ++counts[static_cast<std::size_t>(toy.function(replay).bin)];
  }
  testing::expect_fits(counts, expected);
  // The chains did move.
  double acceptances = 0.0;
  for (const auto& kind : statistics.moves) acceptances += kind.acceptances;
  EXPECT_GT(acceptances, 0.2 * static_cast<double>(statistics.steps));
}

std::vector<std::unique_ptr<Mutation>> mutations() {
  std::vector<std::unique_ptr<Mutation>> result;
  result.push_back(std::make_unique<GaussianMutation>(0.02));
  result.push_back(std::make_unique<KelemenMutation>());
  return result;
}

TEST(ChainStationarity, HoldsWithDefaultSteps) {
  for (const auto& mutation : mutations()) {
    for (const Toy& toy : testing::toys()) {
      SCOPED_TRACE(std::string(mutation->name()) + ", " + toy.name);
      expect_stationary(toy, *mutation, {}, 12);
    }
  }
}

TEST(ChainStationarity, HoldsWithSmallStepsAlone) {
  PrimarySettings settings;
  settings.probabilities.large = 0.0;
  settings.sizes.camera_endpoint.fill(4.F);
  settings.sizes.inner_vertex.fill(3.F);
  settings.sizes.light_endpoint.fill(2.F);
  for (const auto& mutation : mutations()) {
    for (const Toy& toy : testing::toys()) {
      SCOPED_TRACE(std::string(mutation->name()) + ", " + toy.name);
      expect_stationary(toy, *mutation, settings, 12);
    }
  }
}

TEST(ChainStationarity, HoldsWithMovesOfOneHalf) {
  PrimarySettings settings;
  settings.probabilities = {0.1, 0.4, 0.4};
  settings.sizes.camera_endpoint.fill(5.F);
  for (const bool with_light : {false, true}) {
    settings.connection = {!with_light, with_light};
    for (const auto& mutation : mutations()) {
      for (const Toy& toy : {testing::product(), testing::variable_dimension()}) {
        SCOPED_TRACE(std::string(mutation->name()) + ", " + toy.name);
        expect_stationary(toy, *mutation, settings, 12);
      }
    }
  }
}

TEST(ChainStationarity, HoldsForNumbersThatAreSeldomUsed) {
  // Long enough for the errors of lazy numbers to build up: drawn anew after each rejection, they
  // give a statistic of about 2000.
  PrimarySettings settings;
  settings.probabilities.large = 0.0;
  settings.sizes.camera_endpoint.fill(15.F);
  settings.sizes.inner_vertex.fill(5.F);
  for (const auto& mutation : mutations()) {
    SCOPED_TRACE(mutation->name());
    expect_stationary(testing::variable_dimension(), *mutation, settings, 100);
  }
}

TEST(ChainStationarity, HoldsWithSeveralTries) {
  PrimarySettings settings;
  settings.probabilities = {0.1, 0.3, 0.3};
  settings.connection = {true, false};
  settings.sizes.camera_endpoint.fill(4.F);
  settings.sizes.inner_vertex.fill(4.F);
  for (const int tries : {2, 5}) {
    settings.tries = tries;
    for (const auto& mutation : mutations()) {
      for (const Toy& toy : testing::toys()) {
        SCOPED_TRACE(std::string(mutation->name()) + ", " + toy.name);
        expect_stationary(toy, *mutation, settings, 8, 20000);
      }
    }
  }
  // Numbers that some tries use and others do not, without large steps to set them right.
  settings.probabilities = {0.0, 0.0, 0.0};
  settings.sizes.camera_endpoint.fill(15.F);
  expect_stationary(testing::variable_dimension(), GaussianMutation(0.02), settings, 60);
}

TEST(ChainStationarity, HoldsWithStepsOfSeveralLengths) {
  const GaussianMutation mutation(0.08);
  PrimarySettings settings;
  settings.probabilities = {0.1, 0.2, 0.2, 0.6};
  for (const Toy& toy : testing::toys()) {
    SCOPED_TRACE(toy.name);
    expect_stationary(toy, mutation, settings, 12);
  }
  settings.tries = 3;
  expect_stationary(testing::peak(), mutation, settings, 12);
  // Catch-up moves of lazy numbers must have the length of the steps they missed.
  settings.tries = 1;
  settings.probabilities = {0.0, 0.0, 0.0, 0.5};
  settings.sizes.camera_endpoint.fill(3.F);
  expect_stationary(testing::variable_dimension(), mutation, settings, 100);
}

/// States that place themselves by the raster numbers, and states that do not, in equal number;
/// what is counted is 1 + 0.6·cos(2πu), in six bins, of a raster number or of one of the light.
Toy two_techniques() {
  constexpr int kBins = 6;
  Toy toy{"two techniques",
          [](SampleSource& numbers) {
            const bool placed = numbers.get(testing::kChoice) < 0.5F;
            float u = 0.F;
            if (placed) {
              u = numbers.get(testing::kCameraX);
            } else {
              numbers.get({Stream::Camera, 0, kEmissionPosition});
              u = numbers.get(testing::kLight);
            }
            const double value = 1.0 + 0.6 * std::cos(2.0 * double{kPi} * double{u});
            return testing::ToyValue{placed ? value : 0.5 * value,
                                     testing::bin_of(u, kBins) + (placed ? 0 : kBins)};
          },
          1.6, 0.75, std::vector<double>(2 * kBins)};
  const auto upto = [](double u) {
    return u + 0.6 / (2.0 * double{kPi}) * std::sin(2.0 * double{kPi} * u);
  };
  for (std::size_t i = 0; i < kBins; ++i) {
    const double share =
        upto((static_cast<double>(i) + 1.0) / kBins) - upto(static_cast<double>(i) / kBins);
    toy.fractions[i] = 0.5 * share / toy.mean;
    toy.fractions[kBins + i] = 0.25 * share / toy.mean;
  }
  return toy;
}

TEST(ChainStationarity, HoldsWithStepsOfTheRasterNumbersAlone) {
  PrimarySettings settings;
  settings.probabilities = {0.05, 0.2, 0.2, 0.0, 0.7};
  settings.sizes.camera_endpoint.fill(3.F);
  settings.sizes.connection.fill(8.F);
  std::vector<Toy> toys = testing::toys();
  toys.push_back(two_techniques());
  for (const ConnectionMoves moves : {ConnectionMoves{true, false}, ConnectionMoves{false, true}}) {
    settings.connection = moves;
    for (const auto& mutation : mutations()) {
      for (const Toy& toy : toys) {
        SCOPED_TRACE(std::string(mutation->name()) + ", " + toy.name);
        expect_stationary(toy, *mutation, settings, 12);
      }
    }
  }
  // Without large steps to set them right, and with fine steps among them.
  settings.probabilities = {0.0, 0.0, 0.3, 0.2, 0.5};
  settings.sizes.connection.fill(15.F);
  for (const Toy& toy : {two_techniques(), testing::variable_dimension()}) {
    SCOPED_TRACE(toy.name);
    expect_stationary(toy, GaussianMutation(0.05), settings, 60);
  }
}

TEST(ChainStationarity, HoldsWithSeveralTriesAmongStepsOfEveryKind) {
  PrimarySettings settings;
  settings.probabilities = {0.05, 0.2, 0.2, 0.4, 0.5};
  settings.sizes.camera_endpoint.fill(3.F);
  settings.sizes.connection.fill(8.F);
  settings.tries = 3;
  std::vector<Toy> toys = testing::toys();
  toys.push_back(two_techniques());
  for (const Toy& toy : toys) {
    SCOPED_TRACE(toy.name);
    expect_stationary(toy, GaussianMutation(0.05), settings, 12);
  }
  // The kind of a state must be known after a step of several tries, too.
  settings.probabilities = {0.0, 0.0, 0.0, 0.0, 0.5};
  settings.sizes.connection.fill(15.F);
  expect_stationary(two_techniques(), GaussianMutation(0.05), settings, 60);
}

TEST(ChainStationarity, FineStepsNeedAMutationThatDivides) {
  PrimarySettings settings;
  settings.probabilities.fine = 0.1;
  const KelemenMutation kelemen;
  ToyTarget target(testing::peak().function);
  EXPECT_THROW(PrimaryRunner(settings, kelemen, testing::kToyShape, target), std::logic_error);
}

/// Normal steps with a drift: T(to → from) ≠ T(from → to). Moves the first number of a block only.
class Drift final : public Mutation {
 public:
  std::string_view name() const override { return "drift"; }
  void perturb(std::span<float> numbers, std::span<const float> scales, double steps,
               std::uint64_t key) const override {
    const auto whole = static_cast<std::uint64_t>(steps);
    for (std::uint64_t step = 0; step < whole; ++step) {
      const float drifted = numbers[0] + 0.03F;
      numbers[0] = drifted - std::floor(drifted);
      normal_.perturb(numbers.first(2), scales, 1, counter_bits(key, step));
    }
  }
  double density(float from, float to, float scale) const override {
    const float drifted = from + 0.03F;
    return normal_.density(drifted - std::floor(drifted), to, scale);
  }
  double log_ratio(std::span<const float> from, std::span<const float> to,
                   std::span<const float> scales) const override {
    return std::log(density(to[0], from[0], scales[0]) / density(from[0], to[0], scales[0]));
  }

 private:
  GaussianMutation normal_{0.03};
};

TEST(ChainStationarity, HoldsForAMutationThatIsNotSymmetric) {
  PrimarySettings settings;
  settings.probabilities.large = 0.1;
  expect_stationary(testing::peak(), Drift(), settings, 12);
  settings.probabilities.raster = 0.5;
  expect_stationary(testing::peak(), Drift(), settings, 12);
}

}  // namespace
}  // namespace ajar
