#include "mcmc/primary/chain_source.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "mcmc/primary/bootstrap_source.h"
#include "mcmc/primary/gaussian_mutation.h"
#include "mcmc/primary/kelemen_mutation.h"
#include "mcmc/primary/primary_chain.h"
#include "scene/testing/statistics.h"

namespace ajar {
namespace {

constexpr PrimaryShape kShape{4, 3};
constexpr Change kBoth{};

std::vector<SampleAddress> addresses() {
  std::vector<SampleAddress> result;
  for (int slot = 0; slot < static_cast<int>(Slot::kCount); ++slot) {
    for (int v = 0; v < 4; ++v) result.emplace_back(Stream::Camera, v, static_cast<Slot>(slot));
    for (int v = 0; v < 3; ++v) result.emplace_back(Stream::Light, v, static_cast<Slot>(slot));
    result.emplace_back(Stream::Connection, 0, static_cast<Slot>(slot));
  }
  return result;
}
std::vector<float> all_numbers(SampleSource& source) {
  std::vector<float> result;
  for (const SampleAddress address : addresses()) result.push_back(source.get(address));
  return result;
}
std::vector<float> replayed(const ChainNumbers& numbers) {
  ReplaySource source(numbers);
  return all_numbers(source);
}

TEST(ChainNumbers, AChainAtDepth16FitsInFourKibibytes) {
  const PrimaryChain chain({17, 17}, 1, 2, 1.0);
  // Everything the chain occupies between runs, and in a run the undo log on top, which one thread
  // has once for all its chains.
  EXPECT_LE(chain.memory_bytes(), 2048U);
  EXPECT_GE(chain.memory_bytes(), 35U * kBlockSize * sizeof(float));
}

TEST(ChainNumbers, StartAsTheBootstrapSample) {
  BootstrapSource bootstrap(5, 77);
  const ChainNumbers numbers(kShape, bootstrap_key(5, 77));
  EXPECT_EQ(replayed(numbers), all_numbers(bootstrap));
  BootstrapSource other(5, 78);
  EXPECT_NE(replayed(numbers), all_numbers(other));
}

TEST(ChainNumbers, RefuseVerticesBeyondTheirShape) {
  const ChainNumbers numbers(kShape, 1);
  ReplaySource source(numbers);
  EXPECT_NO_THROW(source.get({Stream::Camera, 3, Slot::BsdfLobe}));
  EXPECT_THROW(source.get({Stream::Camera, 4, Slot::BsdfLobe}), std::logic_error);
  EXPECT_THROW(source.get({Stream::Light, 3, Slot::BsdfLobe}), std::logic_error);
  EXPECT_THROW(source.get({Stream::Connection, 1, Slot::BsdfLobe}), std::logic_error);
  EXPECT_THROW(ChainNumbers({-1, 2}, 1), std::logic_error);
}

TEST(BootstrapSource, PairsAreTheirTwoNumbersAndUniform) {
  std::vector<double> counts(256, 0.0);
  const std::vector<double> expected(256, 5000.0 * 80.0 / 256.0);
  for (std::uint64_t i = 0; i < 5000; ++i) {
    BootstrapSource source(1, i);
    for (const SampleAddress address : addresses()) {
      const float u = source.get(address);
      ++counts[static_cast<std::size_t>(u * 256.F)];
      const Vec2 pair = source.get_pair(address);
      EXPECT_EQ(static_cast<int>(address.slot()) % 2 == 0 ? pair.x : pair.y, u);
    }
  }
  testing::expect_fits(counts, expected);
}

TEST(ChainSource, RejectionRestoresEveryNumber) {
  const GaussianMutation mutation(0.05);
  ChainSource source(mutation, {}, kShape);
  ChainNumbers numbers(kShape, 9);
  std::uint64_t key = 100;
  for (const StepKind kind :
       {StepKind::SmallBoth, StepKind::Large, StepKind::SmallCamera, StepKind::SmallRaster}) {
    // From a state in which all numbers have moved.
    source.propose(numbers, StepKind::SmallBoth, kBoth, ++key);
    all_numbers(source);
    source.accept();
    const std::vector<float> before = replayed(numbers);
    source.propose(numbers, kind, change_of(kind, {}, true), ++key);
    EXPECT_NE(all_numbers(source), before);
    source.reject();
    EXPECT_EQ(replayed(numbers), before);
  }
}

TEST(ChainSource, AcceptedNumbersAreThoseThatWereServed) {
  const KelemenMutation mutation;
  ChainSource source(mutation, {}, kShape);
  ChainNumbers numbers(kShape, 9);
  for (const StepKind kind :
       {StepKind::SmallBoth, StepKind::Large, StepKind::SmallLight, StepKind::SmallRaster}) {
    source.propose(numbers, kind, change_of(kind, {}, true), 3);
    const std::vector<float> served = all_numbers(source);
    EXPECT_EQ(all_numbers(source), served) << "a second look";
    const SampleAddress odd(Stream::Light, 1, Slot::LightChoice);
    EXPECT_EQ(source.get_pair(odd).y, source.get(odd));
    source.accept();
    EXPECT_EQ(replayed(numbers), served);
  }
}

TEST(ChainSource, HalfMovesLeaveTheOtherHalf) {
  const GaussianMutation mutation(0.05);
  ChainSource source(mutation, {}, kShape);
  for (const StepKind kind : {StepKind::SmallCamera, StepKind::SmallLight}) {
    ChainNumbers numbers(kShape, 9);
    const std::vector<float> before = replayed(numbers);
    const Change change = change_of(kind, {}, true);
    source.propose(numbers, kind, change, 4);
    const std::vector<float> after = all_numbers(source);
    const auto all = addresses();
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool moves = all[i].stream() == Stream::Light    ? change.light
                         : all[i].stream() == Stream::Camera ? change.camera
                                                             : change.connection;
      EXPECT_EQ(after[i] != before[i], moves);
    }
  }
}

TEST(ChainSource, StepsOfTheRasterNumbersMoveNothingElseAndGoFarther) {
  const GaussianMutation mutation(0.001);
  ChainSource source(mutation, {}, kShape);
  const SampleAddress raster(Stream::Camera, 0, kEmissionDirection);
  testing::Mean squares;
  for (std::uint64_t i = 0; i < 80000; ++i) {
    ChainNumbers numbers(kShape, i);
    // From a state in which all numbers have moved.
    source.propose(numbers, StepKind::SmallBoth, kBoth, 2 * i);
    const std::vector<float> before = all_numbers(source);
    source.accept();
    source.propose(numbers, StepKind::SmallRaster, change_of(StepKind::SmallRaster, {}, true),
                   2 * i + 1);
    const Vec2 to = source.get_pair(raster);
    const std::vector<float> after = all_numbers(source);
    source.accept();
    const auto all = addresses();
    double square = 0.0;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const bool is_raster =
          all[k].stream() == Stream::Camera && all[k].vertex() == 0 &&
          (all[k].slot() == Slot::BsdfDirectionX || all[k].slot() == Slot::BsdfDirectionY);
      if (!is_raster) {
        ASSERT_EQ(after[k], before[k]);
        continue;
      }
      const double shift = double{after[k]} - double{before[k]};
      const double around = shift - std::round(shift);
      square += around * around;
    }
    squares.add(square);
    ASSERT_EQ(ReplaySource(numbers).get_pair(raster), to);
  }
  // Lengths are 1 to 50 times σ, uniform in their logarithm: the mean of their squares is
  // (50² − 1) / (2 ln 50) times σ². 80,000 steps: known to 1 %, 5 σ being 5 %.
  testing::expect_mean(squares, 2.0 * 1e-6 * 2499.0 / (2.0 * std::log(50.0)), 0.06);
}

TEST(ChainSource, UnmovedNumbersMayBeReplaced) {
  const GaussianMutation mutation(0.05);
  ChainSource source(mutation, {}, kShape);
  ChainNumbers numbers(kShape, 9);
  const SampleAddress address(Stream::Camera, 2, Slot::BsdfDirectionX);
  const Vec2 other(0.125F, 0.75F);
  for (const bool accepted : {false, true}) {
    // From a state in which all numbers have moved.
    source.propose(numbers, StepKind::SmallBoth, kBoth, 3);
    std::vector<float> expected = all_numbers(source);
    source.accept();
    source.propose(numbers, StepKind::SmallRaster, change_of(StepKind::SmallRaster, {}, true), 4);
    EXPECT_EQ(source.log_ratio(), 0.0);
    source.replace_pair(address, other, 0.5);
    source.replace_pair({Stream::Camera, 3, Slot::BsdfDirectionX}, other, -0.125);
    EXPECT_EQ(source.get_pair(address), other);
    EXPECT_DOUBLE_EQ(source.log_ratio(), 0.375);
    const std::vector<float> served = all_numbers(source);
    if (accepted) {
      source.accept();
      EXPECT_EQ(replayed(numbers), served);
    } else {
      source.reject();
      EXPECT_EQ(replayed(numbers), expected);
    }
  }
}

TEST(ChainSource, NumbersThatMoveOrAreGivenAreNotReplaced) {
  const GaussianMutation mutation(0.05);
  ChainSource source(mutation, {}, kShape);
  ChainNumbers numbers(kShape, 9);
  const SampleAddress address(Stream::Camera, 2, Slot::BsdfDirectionX);
  for (const StepKind kind : {StepKind::Large, StepKind::SmallBoth, StepKind::SmallCamera}) {
    source.propose(numbers, kind, change_of(kind, {}, true), 3);
    EXPECT_THROW(source.replace_pair(address, Vec2(0.5F, 0.5F), 0.0), std::logic_error);
    source.reject();
  }
  ReplaySource replay(numbers);
  EXPECT_THROW(replay.replace_pair(address, Vec2(0.5F, 0.5F), 0.0), std::logic_error);
}

TEST(ChainSource, LargeStepsAreFreshForBlocksRequestedLater) {
  const GaussianMutation mutation(0.05);
  ChainSource source(mutation, {}, kShape);
  const SampleAddress first(Stream::Camera, 0, Slot::BsdfLobe);
  const SampleAddress later(Stream::Camera, 2, Slot::BsdfLobe);
  ChainNumbers lazy(kShape, 9);
  source.propose(lazy, StepKind::Large, kBoth, 8);
  source.get(first);
  source.accept();
  ChainNumbers eager(kShape, 9);
  source.propose(eager, StepKind::Large, kBoth, 8);
  const float fresh = source.get(later);
  source.accept();
  EXPECT_EQ(ReplaySource(lazy).get(later), fresh);
}

TEST(ChainSource, CatchUpMovesSurviveARejection) {
  const GaussianMutation mutation(0.01);
  ChainSource source(mutation, {}, kShape);
  const SampleAddress used(Stream::Camera, 0, Slot::BsdfLobe);
  const SampleAddress unused(Stream::Camera, 2, Slot::BsdfLobe);
  ChainNumbers numbers(kShape, 9);
  source.propose(numbers, StepKind::SmallBoth, kBoth, 1);
  source.get(used);
  source.accept();
  EXPECT_THROW(ReplaySource(numbers).get(unused), std::logic_error) << "not part of the state";
  source.propose(numbers, StepKind::SmallBoth, kBoth, 2);
  source.get(unused);
  source.reject();
  const float made_up = ReplaySource(numbers).get(unused);
  source.propose(numbers, StepKind::SmallBoth, kBoth, 3);
  source.get(unused);
  source.reject();
  EXPECT_EQ(ReplaySource(numbers).get(unused), made_up);
}

TEST(ChainSource, LazyNumbersAreDistributedAsEagerOnes) {
  // The shift of a number after 12 accepted steps, asked for in every step or only at the end.
  // 150,000 chains: variances agree to 5 standard errors of 0.5 %.
  const GaussianMutation gaussian(0.01);
  const KelemenMutation kelemen;
  for (const Mutation* mutation :
       {static_cast<const Mutation*>(&gaussian), static_cast<const Mutation*>(&kelemen)}) {
    ChainSource source(*mutation, {}, kShape);
    const SampleAddress address(Stream::Light, 1, Slot::LightChoice);
    testing::Mean squares[2];
    for (const bool eager : {false, true}) {
      for (std::uint64_t i = 0; i < 150000; ++i) {
        ChainNumbers numbers(kShape, i);
        const float start = ReplaySource(numbers).get(address);
        for (std::uint64_t step = 0; step < 12; ++step) {
          // Moves of the camera alone must not count.
          const StepKind kind = step % 3 == 0 ? StepKind::SmallCamera : StepKind::SmallBoth;
          source.propose(numbers, kind, change_of(kind, {}, true),
                         hash_numbers(eager ? 1 : 2, i, step));
          if (eager || step == 11) source.get(address);
          source.accept();
        }
        const double shift = double{ReplaySource(numbers).get(address)} - double{start};
        const double around = shift - std::round(shift);
        squares[eager ? 1 : 0].add(around * around);
      }
    }
    testing::expect_same_mean(squares[0], squares[1]);
    if (mutation == &gaussian) testing::expect_mean(squares[0], 8.0 * 1e-4);
  }
}

}  // namespace
}  // namespace ajar
