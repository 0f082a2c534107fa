#include "session/job/preparation.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "session/heuristics.h"
#include "session/testing/thread_ranks.h"

namespace ajar {
namespace {

using namespace std::chrono_literals;

/// Notes what is asked of it. Each round has ten items.
class Prepared final : public Integrator {
 public:
  explicit Prepared(std::vector<double> efforts) : efforts_(std::move(efforts)) {}
  PreparationRound begin_preparation(int round) override {
    EXPECT_FALSE(skipped);
    const auto i = static_cast<std::size_t>(round);
    if (i == efforts_.size()) {
      is_ready = true;
      return {};
    }
    PreparationRound next{.items = 10,
                          .effort = efforts_[i],
                          .stays = stays(i),
                          .serves_alone = serves_alone,
                          .sample_effort = sample_effort};
    for (std::size_t j = i + 1; j < efforts_.size(); ++j) {
      next.later_effort += efforts_[j];
      if (stays(j)) next.later_kept_effort += efforts_[j];
    }
    return next;
  }
  /// After each round, its number.
  std::vector<float> take_first_look() override {
    if (!has_looks) return {};
    return looks_++ == 0 ? std::vector<float>{}
                         : std::vector<float>{static_cast<float>(looks_ - 1)};
  }
  void prepare_item(int round, std::uint64_t /*item*/, Counters& counters) override {
    ++counters.rays;
    if (on_item) on_item(round);
  }
  void skip_preparation(PreparationCut of) override {
    skipped = true;
    preparation_cut = of;
  }

  std::vector<LayerSpec> layers() const override { return {}; }
  std::uint64_t items_in_round() const override { return 0; }
  void run_item(std::uint64_t /*item*/, std::uint64_t /*first_sample*/, std::uint64_t /*samples*/,
                Film& /*film*/, Counters& /*counters*/) override {}
  DevelopScale develop_scale(const LayerSpec& /*layer*/, std::uint64_t /*samples*/,
                             std::optional<int> /*replicate*/) const override {
    return 0.0;
  }

  bool is_ready = false;
  bool skipped = false;
  PreparationCut preparation_cut = PreparationCut::Time;
  std::size_t stays_from = 1000;  ///< round
  std::size_t stays_until = 1000;
  double sample_effort = 1.0;
  bool has_looks = false;
  bool serves_alone = false;
  std::function<void(int round)> on_item;

 private:
  bool stays(std::size_t round) const { return stays_from <= round && round < stays_until; }

  std::vector<double> efforts_;
  int looks_ = 0;
};

TEST(Preparation, RunsAllRounds) {
  Prepared integrator({1.0, 2.0, 0.0});
  Preparation preparation(integrator);
  EXPECT_EQ(preparation.run().rays, 30U);
  EXPECT_TRUE(integrator.is_ready);
  EXPECT_EQ(preparation.end(), PreparationEnd::Done);
}

TEST(Preparation, TellsHowMuchOfTheEffortIsOver) {
  Prepared integrator({1.0, 3.0});
  Preparation preparation(integrator);
  EXPECT_EQ(preparation.fraction_done(), 0.0);
  std::vector<double> least = {1.0, 1.0};
  std::vector<double> most = {0.0, 0.0};
  std::mutex mutex;
  integrator.on_item = [&](int round) {
    const std::lock_guard lock(mutex);
    double& low = least[static_cast<std::size_t>(round)];
    double& high = most[static_cast<std::size_t>(round)];
    low = std::min(low, preparation.fraction_done());
    high = std::max(high, preparation.fraction_done());
  };
  preparation.run();
  EXPECT_EQ(least[0], 0.0);
  EXPECT_EQ(least[1], 0.25);
  EXPECT_LE(most[0], 0.25);
  EXPECT_GT(most[1], 0.5);
  EXPECT_EQ(preparation.fraction_done(), 1.0);
}

/// A round after one that took 30 of 100 seconds: of what is thrown away, 25 are allowed.
TEST(Preparation, TimeOfRoundsThatAreKeptDoesNotCountAgainstOthers) {
  for (const bool is_kept : {false, true}) {
    Prepared integrator({3.0, 1.0});
    integrator.stays_from = 0;
    integrator.stays_until = is_kept ? 1 : 0;
    std::atomic<int> now{0};
    integrator.on_item = [&](int round) { now += round == 0 ? 3 : 1; };
    Preparation preparation(integrator, {.seconds = 100.0, .clock = [&] { return now.load(); }});
    preparation.run();
    EXPECT_EQ(integrator.is_ready, is_kept);
  }
}

TEST(Preparation, IsSkippedWhenTheUserWantsToStop) {
  for (const int round : {0, 1}) {
    Prepared integrator({1.0, 1.0});
    InterruptCount interrupts{0};
    integrator.on_item = [&](int now) {
      if (now == round) interrupts = 1;
    };
    Preparation preparation(integrator, {.interrupts = &interrupts});
    const std::uint64_t rays = preparation.run().rays;
    EXPECT_TRUE(integrator.skipped);
    EXPECT_EQ(preparation.end(), PreparationEnd::Interrupted);
    EXPECT_FALSE(integrator.is_ready);
    EXPECT_GE(rays, static_cast<std::uint64_t>(10 * round + 1));
  }
}

TEST(Preparation, IsSkippedWithoutTimeForIt) {
  Prepared integrator({1.0});
  Preparation preparation(integrator, {.seconds = 0.0});
  EXPECT_EQ(preparation.run().rays, 0U);
  EXPECT_EQ(preparation.end(), PreparationEnd::NoTime);
}

TEST(Preparation, IsSkippedOnceItsFirstRoundShowsThatItTakesTooLong) {
  for (const double later : {1e9, 0.0}) {
    Prepared integrator({1.0, later});
    integrator.on_item = [](int) { std::this_thread::sleep_for(1ms); };
    Preparation preparation(integrator, {.seconds = 1000.0});
    EXPECT_EQ(preparation.run().rays, later > 0.0 ? 10U : 20U);
    EXPECT_EQ(preparation.end(), later > 0.0 ? PreparationEnd::NoTime : PreparationEnd::Done);
  }
}

TEST(Preparation, TakesItsTimeByTheClockThatItIsGiven) {
  for (const double per_item : {0.001, 1.0}) {
    Prepared integrator({1.0});
    std::atomic<double> now = 1e6;
    integrator.on_item = [&](int) { now = now + per_item; };
    Preparation preparation(integrator, {.seconds = 10.0, .clock = [&] { return now.load(); }});
    preparation.run();
    EXPECT_EQ(preparation.end(), per_item < 0.1 ? PreparationEnd::Done : PreparationEnd::NoTime);
    EXPECT_GT(preparation.seconds(), 0.0);
    EXPECT_LT(preparation.seconds(), 12.0);
  }
}

TEST(Preparation, TakesAQuarterOfTheTimeAtMost) {
  for (const double seconds : {0.5, 1e3}) {
    // By the clock alone: it could not know that a round would take so long.
    Prepared integrator({1.0});
    integrator.on_item = [](int) { std::this_thread::sleep_for(100ms); };
    Preparation preparation(integrator, {.seconds = seconds});
    const std::uint64_t rays = preparation.run().rays;
    EXPECT_EQ(rays == 10U, seconds > 100.0);
    EXPECT_EQ(preparation.end(), seconds > 100.0 ? PreparationEnd::Done : PreparationEnd::NoTime);
  }
  // By what is to come: ten items of 10 ms are a fifth of a second at least, of which a third
  // would be more than a quarter.
  Prepared integrator({1.0, 1.0, 1.0});
  integrator.on_item = [](int) { std::this_thread::sleep_for(20ms); };
  Preparation preparation(integrator, {.seconds = 1.0});
  EXPECT_LE(preparation.run().rays, 20U);
  EXPECT_EQ(preparation.end(), PreparationEnd::NoTime);
  EXPECT_LE(preparation.rounds(), 1U);
}

TEST(Preparation, GivesUpARoundThatShowsThatItWillBeLate) {
  Prepared integrator({1.0});
  integrator.on_item = [](int) { std::this_thread::sleep_for(300ms); };
  // Ten items on two threads take more than a second, of which each shows a tenth.
  tbb::task_arena(2).execute([&] {
    Preparation preparation(integrator, {.seconds = 4.0});
    EXPECT_LE(preparation.run().rays, 4U);
    EXPECT_EQ(preparation.end(), PreparationEnd::NoTime);
  });
}

/// More than a quarter of the time, and less than half.
TEST(Preparation, FinishesWhatBecomesPartOfThePicture) {
  for (const bool stays : {false, true}) {
    Prepared integrator({1.0, 1.0});
    integrator.stays_from = stays ? 0 : 1000;
    integrator.on_item = [](int) { std::this_thread::sleep_for(100ms); };
    tbb::task_arena(1).execute([&] {
      Preparation preparation(integrator, {.seconds = 3.9});
      EXPECT_EQ(preparation.run().rays == 10U, stays);
      EXPECT_EQ(preparation.rounds(), stays ? 1U : 0U);
      EXPECT_EQ(preparation.end(), PreparationEnd::NoTime) << "no other round is begun";
    });
  }
}

/// A round that is lost, and four times as much that is not.
TEST(Preparation, MayTakeHalfOfTheTimeForWhatStays) {
  for (const bool stays : {false, true}) {
    Prepared integrator({1.0, 4.0});
    integrator.stays_from = stays ? 1 : 1000;
    std::atomic<double> now = 0.0;
    integrator.on_item = [&](int round) { now = now + (round == 0 ? 0.1 : 0.4); };
    Preparation preparation(integrator, {.seconds = 12.0, .clock = [&] { return now.load(); }});
    EXPECT_EQ(preparation.run().rays, stays ? 20U : 10U);
    EXPECT_EQ(preparation.end(), stays ? PreparationEnd::Done : PreparationEnd::NoTime);
  }
}

/// Later rounds would take too long in either case.
TEST(Preparation, RunsRoundsThatServeAlone) {
  for (const bool alone : {false, true}) {
    Prepared integrator({1.0, 1.0, 1e9});
    integrator.serves_alone = alone;
    integrator.on_item = [](int) { std::this_thread::sleep_for(1ms); };
    Preparation preparation(integrator, {.seconds = 1000.0});
    EXPECT_EQ(preparation.run().rays, alone ? 20U : 10U);
    EXPECT_TRUE(integrator.skipped);
    EXPECT_EQ(preparation.end(), PreparationEnd::NoTime);
  }
}

TEST(Preparation, IsSkippedWhereThePictureHasFewSamples) {
  struct Case {
    const char* what;
    std::vector<double> efforts;
    std::uint64_t enough;  ///< samples; one less is too few
    std::size_t stays_from = 1000;
    double sample_effort = 1.0;
  };
  const std::vector<Case> cases = {
      // Discarded samples are a quarter of all effort at most: 3 of 9 + 3.
      {"nothing stays", {1.0, 2.0}, 9},
      // 7 of 11 + 3.
      {"half of all", {3.0, 4.0}, 11, 1},
      {"hardly anything is lost", {0.1, 4.0}, 9, 1},
      {"dear samples", {3.0}, 5, 1000, 2.0},
  };
  for (const Case& c : cases) {
    for (const std::uint64_t samples : {c.enough - 1, c.enough}) {
      SCOPED_TRACE(std::string(c.what) + ", " + std::to_string(samples));
      Prepared integrator(c.efforts);
      integrator.stays_from = c.stays_from;
      integrator.sample_effort = c.sample_effort;
      PreparationLimits limits{.samples = samples, .pixels = 1000000000};
      Preparation preparation(integrator, limits);
      const std::uint64_t rays = preparation.run().rays;
      const bool enough = samples == c.enough;
      EXPECT_EQ(rays, enough ? 10 * c.efforts.size() : 0U);
      EXPECT_EQ(preparation.end(), enough ? PreparationEnd::Done : PreparationEnd::FewSamples);
      EXPECT_EQ(integrator.skipped, !enough);
      if (!enough) {
        EXPECT_EQ(integrator.preparation_cut, PreparationCut::Samples);
      }
    }
  }
}

TEST(Preparation, IsNotSkippedForWantOfSamplesIfItIsShortOrWasAskedFor) {
  for (const bool few : {true, false}) {
    for (const double sample_effort : {1.0, 0.0}) {
      Prepared integrator({2.0});
      integrator.sample_effort = sample_effort;
      const auto pixels = static_cast<std::uint64_t>(SessionHeuristics::kFewToPrepare / 2.0);
      Preparation preparation(integrator, {.samples = 1, .pixels = few ? pixels : pixels + 1});
      preparation.run();
      const bool runs = few || sample_effort == 0.0;
      EXPECT_EQ(preparation.end(), runs ? PreparationEnd::Done : PreparationEnd::FewSamples);
    }
  }
}

/// Later rounds would be too much in either case.
TEST(Preparation, RunsRoundsThatServeAloneOfFewSamples) {
  for (const bool alone : {false, true}) {
    Prepared integrator({1.0, 1.0, 1e9});
    integrator.serves_alone = alone;
    Preparation preparation(integrator, {.samples = 9, .pixels = 1000000000});
    EXPECT_EQ(preparation.run().rays, alone ? 20U : 0U);
    EXPECT_EQ(preparation.end(), PreparationEnd::FewSamples);
  }
}

TEST(Preparation, ShowsWhatItHasSeen) {
  Prepared integrator({1.0, 1.0});
  integrator.has_looks = true;
  std::vector<float> seen;
  Preparation preparation(integrator, {}, [&](const std::vector<float>& rgb) {
    seen.insert(seen.end(), rgb.begin(), rgb.end());
  });
  preparation.run();
  EXPECT_EQ(seen, (std::vector<float>{1.F, 2.F}));
}

TEST(Preparation, ComesAsFarAsAnEarlierRun) {
  for (const std::uint64_t rounds : {0, 1, 2, 3}) {
    Prepared integrator({1.0, 1.0, 1.0});
    PreparationLimits limits;
    limits.earlier = {rounds, rounds % 2 == 0 ? PreparationCut::Time : PreparationCut::Samples};
    Preparation preparation(integrator, limits);
    EXPECT_EQ(preparation.run().rays, 10 * rounds);
    EXPECT_EQ(preparation.rounds(), rounds);
    EXPECT_EQ(integrator.skipped, rounds < 3);
    EXPECT_EQ(integrator.is_ready, rounds == 3);
    if (rounds == 3) continue;
    EXPECT_EQ(integrator.preparation_cut, limits.earlier->of);
    EXPECT_EQ(preparation.end(),
              rounds % 2 == 0 ? PreparationEnd::NoTime : PreparationEnd::FewSamples);
  }
}

TEST(Preparation, IsSkippedByAllRanksIfByOne) {
  ThreadRanks ranks(3);
  std::vector<std::thread> threads;
  threads.reserve(3);
  for (int rank = 0; rank < 3; ++rank) {
    threads.emplace_back([&ranks, rank] {
      Prepared integrator({1.0, 1.0});
      InterruptCount interrupts{0};
      integrator.on_item = [&](int) { interrupts = rank == 1 ? 1 : 0; };
      Preparation preparation(integrator,
                              {.interrupts = &interrupts, .ranks = &ranks.member(rank)});
      EXPECT_EQ(preparation.run().rays, 10U) << "ranks look between rounds only";
      EXPECT_EQ(preparation.end(), PreparationEnd::Interrupted);
    });
  }
  for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace ajar
