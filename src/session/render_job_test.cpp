#include "session/render_job.h"

#include <gtest/gtest.h>

#include <mutex>
#include <set>
#include <vector>

#include "session/test_integrator.h"

namespace ajar {
namespace {

const Vec2i kSize(13, 7);

Film make_film(const TestIntegrator& integrator, int replicates) {
  return {kSize, Box2i(Vec2i(0, 0), kSize - Vec2i(1, 1)), Filter::box(), replicates,
          integrator.layers()};
}

std::vector<std::int64_t> render(RenderJobOptions options, int replicates = 4,
                                 RenderResult* result = nullptr) {
  TestIntegrator integrator(kSize, replicates);
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
  TestIntegrator integrator(kSize, 4);
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
  options.estimate_error = [](const Film&, std::uint64_t) { return std::optional(0.5); };
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
  EXPECT_LT(result.seconds, 3.0);
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
      return std::optional(1.0 / std::sqrt(static_cast<double>(samples)));
    };
    RenderResult result;
    render(options, 4, &result);
    EXPECT_EQ(result.stopped_by, StopReason::TargetError);
    EXPECT_EQ(result.samples_per_pixel, 128U);
    EXPECT_NEAR(result.relative_error.value(), 0.0884, 0.001);
  }
}

TEST(RenderJob, DoesNotTrustAnErrorFromVeryFewSamples) {
  RenderJobOptions options = with_samples(64, 1);
  options.budget.target_error = 0.1;
  options.estimate_error = [](const Film&, std::uint64_t) { return std::optional(0.0); };
  RenderResult result;
  render(options, 4, &result);
  EXPECT_EQ(result.samples_per_pixel, 16U);
}

TEST(RenderJob, FinishesThePassAtTheFirstInterrupt) {
  TestIntegrator integrator(kSize, 4);
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
  for (std::uint64_t i = 0; i < integrator.items_in_pass(); ++i) {
    Counters counters;
    integrator.run_item(i, 0, 9, whole, counters);
  }
  EXPECT_EQ(interrupted, std::vector<std::int64_t>(whole.raw().begin(), whole.raw().end()));
}

TEST(RenderJob, SkipsWhatHasNotBegunAtTheSecondInterrupt) {
  TestIntegrator integrator(kSize, 4);
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
  TestIntegrator integrator(kSize, 4);
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

TEST(RenderJob, SnapshotSaysWhereTheRenderStands) {
  TestIntegrator integrator(kSize, 4);
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
