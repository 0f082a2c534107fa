#include "session/job/render_job.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include "session/testing/test_integrator.h"
#include "session/testing/thread_ranks.h"

namespace ajar {
namespace {

/// Falls like noise does.
RelativeError error_after(std::uint64_t samples) {
  return {.value = 1.0 / std::sqrt(static_cast<double>(samples))};
}

const Vec2i kJobSize(13, 7);

Film make_film(const TestIntegrator& integrator, int replicates) {
  return {kJobSize, Box2i(Vec2i(0, 0), kJobSize - Vec2i(1, 1)), Filter::box(), replicates,
          integrator.layers()};
}

std::vector<std::int64_t> render(RenderJobOptions options, int replicates = 4,
                                 RenderResult* result = nullptr) {
  TestIntegrator integrator(kJobSize, replicates);
  Film film = make_film(integrator, replicates);
  RenderJob job(integrator, film, std::move(options));
  const RenderResult r = job.run();
  if (result != nullptr) *result = r;
  return {film.raw().begin(), film.raw().end()};
}

RenderJobOptions with_samples(std::uint64_t samples, int threads) {
  RenderJobOptions options;
  options.budget.samples_per_pixel = samples;
  options.threads = threads;
  return options;
}

TEST(RenderJob, GivesTheSameBitsOnAnyNumberOfThreads) {
  RenderResult one;
  const auto reference = render(with_samples(40, 1), 4, &one);
  for (const int threads : {2, 5}) {
    RenderResult many;
    EXPECT_EQ(render(with_samples(40, threads), 4, &many), reference) << threads << " threads";
    EXPECT_EQ(many.counters.rays, one.counters.rays);
    EXPECT_EQ(many.counters.first_discarded, one.counters.first_discarded);
    EXPECT_EQ(many.threads, threads);
  }
}

TEST(RenderJob, CountsTheProcessorTimeOfChainsAndNotTheirWaiting) {
  TestIntegrator integrator(kJobSize, 1);
  integrator.has_chains = true;
  // A machine that is busy with something else.
  integrator.on_item = [](auto...) { std::this_thread::sleep_for(std::chrono::milliseconds(1)); };
  Film film = make_film(integrator, 1);
  const RenderResult result = RenderJob(integrator, film, with_samples(1, 1)).run();
  EXPECT_GE(result.seconds, 0.09);
  EXPECT_GT(result.chain_seconds, 0.0);
  EXPECT_LT(result.chain_seconds, 0.5 * result.seconds);
}

TEST(RenderJob, DoesNotDependOnHowSamplesAreCutIntoPasses) {
  RenderJobOptions hasty = with_samples(64, 2);
  hasty.pass_seconds = 0.0;  // the shortest passes there are
  RenderResult in_short_passes;
  RenderResult in_long_passes;
  EXPECT_EQ(render(hasty, 4, &in_short_passes), render(with_samples(64, 2), 4, &in_long_passes));
  EXPECT_EQ(in_short_passes.passes, 64U);
  EXPECT_LT(in_long_passes.passes, 16U);
}

TEST(RenderJob, TakesEverySampleOfEveryPixelOnce) {
  TestIntegrator integrator(kJobSize, 4);
  std::mutex mutex;
  std::set<std::pair<std::uint64_t, std::uint64_t>> seen;
  bool twice = false;
  integrator.on_item = [&](std::uint64_t item, std::uint64_t first, std::uint64_t samples) {
    const std::lock_guard lock(mutex);
    for (std::uint64_t i = first; i < first + samples; ++i) {
      twice = twice || !seen.insert({item, i}).second;
    }
  };
  Film film = make_film(integrator, 4);
  RenderJob job(integrator, film, with_samples(24, 3));
  const RenderResult result = job.run();
  EXPECT_FALSE(twice);
  EXPECT_EQ(seen.size(), 24U * 13U * 7U);
  EXPECT_EQ(result.samples_per_pixel, 24U);
  EXPECT_EQ(result.counters.samples, 24U * 13U * 7U);
  EXPECT_EQ(result.stopped_by, StopReason::Samples);
}

TEST(RenderJob, RoundsSamplesUpToEqualReplicates) {
  RenderResult result;
  render(with_samples(6, 2), 4, &result);
  EXPECT_EQ(result.samples_per_pixel, 8U);
}

TEST(RenderJob, RendersASingleSampleWithOneReplicate) {
  RenderResult result;
  RenderJobOptions options = with_samples(1, 2);
  options.estimate_error = [](const Film&, std::uint64_t) {
    return std::optional(RelativeError{.value = 0.5});
  };
  render(options, 1, &result);
  EXPECT_EQ(result.samples_per_pixel, 1U);
  EXPECT_FALSE(result.relative_error.has_value());
}

TEST(RenderJob, StopsWhenTimeIsUp) {
  RenderJobOptions options;
  options.budget.seconds = 0.3;
  options.threads = 2;
  options.pass_seconds = 0.05;
  RenderResult result;
  render(options, 4, &result);
  EXPECT_EQ(result.stopped_by, StopReason::Time);
  EXPECT_GE(result.samples_per_pixel, 1U);
  EXPECT_GT(result.seconds, 0.1);
  // Generous: the machine may be busy.
  EXPECT_LT(result.seconds, 60.0);
}

TEST(RenderJob, RendersOnePassHoweverLittleTimeThereIs) {
  RenderJobOptions options;
  options.budget.seconds = 1e-9;
  RenderResult result;
  render(options, 4, &result);
  EXPECT_EQ(result.samples_per_pixel, 1U);
  EXPECT_TRUE(result.complete);
}

TEST(RenderJob, StopsAtTheSameSampleWhenTheErrorIsReached) {
  for (const double pass_seconds : {0.0, 10.0}) {
    RenderJobOptions options = with_samples(100000, 2);
    options.pass_seconds = pass_seconds;
    options.budget.target_error = 0.1;
    // Falls like noise does: 0.1 is reached at 100 samples, the next milestone is 4 · 32.
    options.estimate_error = [](const Film&, std::uint64_t samples) {
      return error_after(samples);
    };
    RenderResult result;
    render(options, 4, &result);
    EXPECT_EQ(result.stopped_by, StopReason::TargetError);
    EXPECT_EQ(result.samples_per_pixel, 128U);
    EXPECT_NEAR(result.relative_error.value().value, 0.0884, 0.001);
  }
}

TEST(RenderJob, TargetsMayBeOfTheDenoisedPicture) {
  RenderJobOptions options = with_samples(100000, 2);
  options.budget.target_error = 0.1;
  options.budget.denoised_target = true;
  options.estimate_error = [](const Film&, std::uint64_t samples) { return error_after(samples); };
  // A filter that is worth four times the samples.
  options.estimate_denoised_error = [](const Film&, std::uint64_t samples) {
    return error_after(4 * samples).value;
  };
  RenderResult result;
  render(options, 4, &result);
  EXPECT_EQ(result.stopped_by, StopReason::TargetError);
  EXPECT_EQ(result.samples_per_pixel, 32U);
  EXPECT_NEAR(result.relative_error.value().value, error_after(32).value, 1e-6);
}

TEST(RenderJob, DoesNotTrustALowerBound) {
  for (const std::uint64_t bound_until : {0, 256, 100000}) {
    RenderJobOptions options = with_samples(2000, 2);
    options.budget.target_error = 0.1;
    options.estimate_error = [&](const Film&, std::uint64_t samples) {
      RelativeError error = error_after(samples);
      error.has_fireflies = samples <= bound_until;
      return std::optional(error);
    };
    RenderResult result;
    render(options, 4, &result);
    EXPECT_EQ(result.stopped_by,
              bound_until < 2000 ? StopReason::TargetError : StopReason::Samples);
    EXPECT_EQ(result.samples_per_pixel, bound_until == 0     ? 128U
                                        : bound_until == 256 ? 768U
                                                             : 2000U)
        << "three estimates that can be trusted must agree";
  }
}

TEST(RenderJob, DoesNotTrustAnErrorFromVeryFewSamples) {
  RenderJobOptions options = with_samples(64, 1);
  options.budget.target_error = 0.1;
  options.estimate_error = [](const Film&, std::uint64_t) {
    return std::optional(RelativeError{.value = 0.0});
  };
  RenderResult result;
  render(options, 4, &result);
  EXPECT_EQ(result.samples_per_pixel, 16U);
}

TEST(RenderJob, FinishesThePassAtTheFirstInterrupt) {
  TestIntegrator integrator(kJobSize, 4);
  InterruptCount interrupts{0};
  integrator.on_item = [&](std::uint64_t item, std::uint64_t first, std::uint64_t) {
    if (item == 20 && first >= 8) interrupts = 1;
  };
  Film film = make_film(integrator, 4);
  RenderJobOptions options = with_samples(100000, 2);
  options.pass_seconds = 0.0;
  options.interrupts = &interrupts;
  RenderJob job(integrator, film, options);
  const RenderResult result = job.run();
  EXPECT_EQ(result.stopped_by, StopReason::Interrupted);
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.samples_per_pixel, 9U);
  const std::vector<std::int64_t> interrupted(film.raw().begin(), film.raw().end());
  // Replicate 0 has a sample more than the others.
  Film whole = make_film(integrator, 4);
  integrator.on_item = nullptr;
  for (std::uint64_t i = 0; i < integrator.items_in_round(); ++i) {
    Counters counters;
    integrator.run_item(i, 0, 9, whole, counters);
  }
  EXPECT_EQ(interrupted, std::vector<std::int64_t>(whole.raw().begin(), whole.raw().end()));
}

TEST(RenderJob, SkipsWhatHasNotBegunAtTheSecondInterrupt) {
  TestIntegrator integrator(kJobSize, 4);
  InterruptCount interrupts{0};
  integrator.on_item = [&](std::uint64_t, std::uint64_t first, std::uint64_t) {
    if (first >= 8) interrupts = 2;
  };
  Film film = make_film(integrator, 4);
  RenderJobOptions options = with_samples(100000, 2);
  options.pass_seconds = 0.0;
  options.interrupts = &interrupts;
  RenderJob job(integrator, film, options);
  const RenderResult result = job.run();
  EXPECT_EQ(result.stopped_by, StopReason::Interrupted);
  EXPECT_FALSE(result.complete);
  EXPECT_LT(result.counters.samples, 12U * 13U * 7U);
  EXPECT_GE(result.samples_per_pixel, 8U);
}

TEST(RenderJob, PassesOnWhatAnItemRaises) {
  TestIntegrator integrator(kJobSize, 4);
  integrator.on_item = [](std::uint64_t item, std::uint64_t, std::uint64_t) {
    if (item == 17) throw std::bad_alloc();
  };
  Film film = make_film(integrator, 4);
  RenderJob job(integrator, film, with_samples(8, 3));
  EXPECT_THROW(job.run(), std::bad_alloc);
}

TEST(RenderJob, KeepsTheFirstDiscardedContribution) {
  RenderResult result;
  render(with_samples(8, 5), 4, &result);
  EXPECT_EQ(result.counters.first_discarded, "item 3");
  EXPECT_EQ(result.counters.discarded_nan, 18U);  // items 3, 8, … 88
}

/// Renders to `total` samples in pieces: from pass to pass, each time as a new job.
std::vector<std::int64_t> render_in_pieces(std::uint64_t total, int replicates, int* pieces) {
  Film film = make_film(TestIntegrator(kJobSize, replicates), replicates);
  JobState state;
  for (*pieces = 0; state.samples_per_pixel < total; ++*pieces) {
    TestIntegrator integrator(kJobSize, replicates);
    Film next = make_film(integrator, replicates);
    next.take_raw({film.raw().begin(), film.raw().end()});
    RenderJobOptions options = with_samples(total, 1 + *pieces % 3);
    InterruptCount interrupts{0};
    options.interrupts = &interrupts;
    options.pass_seconds = 0.0;
    options.resumed = state;
    integrator.on_item = [&](std::uint64_t, std::uint64_t, std::uint64_t) { interrupts = 1; };
    RenderJob job(integrator, next, options);
    job.run();
    EXPECT_GT(job.state().samples_per_pixel, state.samples_per_pixel);
    state = job.state();
    film.take_raw({next.raw().begin(), next.raw().end()});
  }
  EXPECT_EQ(state.counters.samples, total * 13 * 7);
  EXPECT_EQ(state.counters.first_discarded, "item 3");
  EXPECT_EQ(state.passes, total);
  return {film.raw().begin(), film.raw().end()};
}

TEST(RenderJob, ResumedAfterEveryPassGivesTheSameBits) {
  int pieces = 0;
  EXPECT_EQ(render_in_pieces(40, 4, &pieces), render(with_samples(40, 2)));
  EXPECT_EQ(pieces, 40);
}

TEST(RenderJob, ResumedInTheMiddleOfAPassGivesTheSameBits) {
  for (const int threads : {1, 4}) {
    TestIntegrator integrator(kJobSize, 4);
    InterruptCount interrupts{0};
    integrator.on_item = [&](std::uint64_t item, std::uint64_t first, std::uint64_t) {
      if (item == 20 && first >= 8) interrupts = 2;
    };
    Film film = make_film(integrator, 4);
    RenderJobOptions options = with_samples(40, threads);
    options.interrupts = &interrupts;
    RenderJob cut(integrator, film, options);
    EXPECT_FALSE(cut.run().complete);
    ASSERT_TRUE(cut.state().partial.has_value());
    EXPECT_EQ(cut.state().samples_per_pixel, 8U);
    options.interrupts = nullptr;
    options.resumed = cut.state();
    RenderJob rest(integrator, film, options);
    const RenderResult result = rest.run();
    EXPECT_TRUE(result.complete);
    EXPECT_EQ(result.counters.samples, 40U * 13U * 7U);
    EXPECT_EQ(std::vector<std::int64_t>(film.raw().begin(), film.raw().end()),
              render(with_samples(40, 2)));
  }
}

TEST(RenderJob, SecondsAndSpeedOfEarlierRunsAreKeptApart) {
  TestIntegrator integrator(kJobSize, 4);
  Film film = make_film(integrator, 4);
  RenderJobOptions options;
  options.budget.seconds = 100.0;
  options.resumed.emplace();
  options.resumed->samples_per_pixel = 8;
  options.resumed->passes = 3;
  options.resumed->seconds = 99.999999;
  options.resumed->seconds_per_sample = 1e-9;
  options.pass_seconds = 50.0;
  const RenderResult result = RenderJob(integrator, film, options).run();
  EXPECT_EQ(result.stopped_by, StopReason::Time);
  EXPECT_LE(result.samples_per_pixel, 9U) << "the speed of another machine is not trusted";
  EXPECT_GE(result.seconds, 99.999999);
  EXPECT_LT(result.own_seconds, 50.0);
}

TEST(RenderJob, StopsAtTheSameSampleWhenResumed) {
  const auto options_to = [](std::optional<JobState> state, std::uint64_t most) {
    RenderJobOptions options = with_samples(most, 2);
    options.budget.target_error = 0.1;
    options.estimate_error = [](const Film&, std::uint64_t samples) {
      // A lucky estimate at 48 samples, which must not end the render.
      return samples == 48 ? RelativeError{.value = 0.01} : error_after(samples);
    };
    options.resumed = std::move(state);
    return options;
  };
  TestIntegrator integrator(kJobSize, 4);
  for (const std::uint64_t stop : {4U, 44U, 48U, 56U, 64U, 100U, 128U}) {
    Film film = make_film(integrator, 4);
    RenderJob first(integrator, film, options_to(std::nullopt, stop));
    first.run();
    RenderJob second(integrator, film, options_to(first.state(), 100000));
    const RenderResult result = second.run();
    EXPECT_EQ(result.samples_per_pixel, 128U) << "resumed at " << stop;
    EXPECT_EQ(result.stopped_by, StopReason::TargetError);
  }
}

/// All ranks render on threads of their own; returns the root's film.
std::vector<std::int64_t> render_on_ranks(int count, const RenderJobOptions& options,
                                          RenderResult* root_result) {
  ThreadRanks ranks(count);
  std::vector<std::int64_t> sums;
  std::vector<std::thread> threads;
  threads.reserve(static_cast<std::size_t>(count));
  for (int rank = 0; rank < count; ++rank) {
    threads.emplace_back([&, rank] {
      TestIntegrator integrator(kJobSize, 4);
      Film film = make_film(integrator, 4);
      RenderJobOptions own = options;
      own.ranks = &ranks.member(rank);
      RenderJob job(integrator, film, own);
      const RenderResult result = job.run();
      if (rank != 0) return;
      sums.assign(job.film().raw().begin(), job.film().raw().end());
      *root_result = result;
    });
  }
  for (std::thread& thread : threads) thread.join();
  return sums;
}

TEST(RenderJob, GivesTheSameBitsOnAnyNumberOfRanks) {
  const auto reference = render(with_samples(40, 1));
  for (const int count : {1, 2, 3}) {
    RenderJobOptions options = with_samples(40, 2);
    options.pass_seconds = 0.0;
    options.estimate_error = [](const Film&, std::uint64_t) {
      return std::optional(RelativeError{.value = 0.5});
    };
    RenderResult result;
    EXPECT_EQ(render_on_ranks(count, options, &result), reference) << count << " ranks";
    EXPECT_EQ(result.counters.samples, 40U * 13U * 7U);
    EXPECT_EQ(result.counters.discarded_nan, 18U);
    EXPECT_EQ(result.counters.rays_out_of_range, 18U);
    EXPECT_EQ(result.relative_error.value().value, 0.5);
  }
}

TEST(RenderJob, RanksStopTogether) {
  RenderJobOptions by_error = with_samples(100000, 1);
  by_error.budget.target_error = 0.1;
  by_error.estimate_error = [](const Film&, std::uint64_t samples) { return error_after(samples); };
  RenderResult result;
  render_on_ranks(3, by_error, &result);
  EXPECT_EQ(result.stopped_by, StopReason::TargetError);
  EXPECT_EQ(result.samples_per_pixel, 128U);
  RenderJobOptions by_signal = with_samples(1U << 30U, 1);
  const InterruptCount interrupts{2};
  by_signal.interrupts = &interrupts;
  render_on_ranks(2, by_signal, &result);
  EXPECT_EQ(result.stopped_by, StopReason::Interrupted);
  EXPECT_TRUE(result.complete) << "ranks finish the pass";
}

TEST(RenderJob, SharesAddUpToTheWholeBitByBit) {
  const auto reference = render(with_samples(24, 2));
  std::vector<std::int64_t> sum(reference.size());
  std::uint64_t samples = 0;
  for (std::uint64_t i = 0; i < 3; ++i) {
    RenderJobOptions options = with_samples(24, 2);
    options.share = {i, 3};
    RenderResult result;
    const auto part = render(options, 4, &result);
    std::transform(sum.begin(), sum.end(), part.begin(), sum.begin(), std::plus<>());
    samples += result.counters.samples;
    EXPECT_TRUE(result.complete);
    EXPECT_EQ(result.samples_per_pixel, 24U);
  }
  EXPECT_EQ(sum, reference);
  EXPECT_EQ(samples, 24U * 13U * 7U);
}

class CountingObserver final : public PassObserver {
 public:
  bool wants_picture(const JobState& /*state*/) override { return ++asked % 3 == 0; }
  void see_picture(const Film& film, const JobState& state) override {
    ++seen;
    samples = state.samples_per_pixel;
    sum = film.raw()[0];
  }
  int asked = 0;
  int seen = 0;
  std::uint64_t samples = 0;
  std::int64_t sum = 0;
};

TEST(RenderJob, ShowsThePictureToThoseWhoWantIt) {
  TestIntegrator integrator(kJobSize, 4);
  Film film = make_film(integrator, 4);
  RenderJobOptions options = with_samples(16, 2);
  options.pass_seconds = 0.0;
  CountingObserver observer;
  options.observers = {&observer};
  RenderJob(integrator, film, options).run();
  EXPECT_EQ(observer.asked, 17) << "before every pass and at the end";
  EXPECT_EQ(observer.seen, 5);
  EXPECT_EQ(observer.samples, 14U);
  EXPECT_NE(observer.sum, 0);
}

TEST(RenderJob, SnapshotSaysWhereTheRenderStands) {
  TestIntegrator integrator(kJobSize, 4);
  Film film = make_film(integrator, 4);
  RenderJob job(integrator, film, with_samples(16, 2));
  EXPECT_EQ(job.snapshot().samples_done, 0.0);
  job.run();
  const RenderSnapshot after = job.snapshot();
  EXPECT_EQ(after.samples_done, 16.0);
  EXPECT_EQ(after.total_samples, 16U);
  EXPECT_EQ(after.rays, 2U * 16U * 13U * 7U);
}

}  // namespace
}  // namespace ajar
