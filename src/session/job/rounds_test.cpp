#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <thread>
#include <vector>

#include "core/archive.h"
#include "core/error.h"
#include "session/job/render_job.h"
#include "session/testing/thread_ranks.h"

/// Passes of several rounds, with a barrier between them.
namespace ajar {
namespace {

const Vec2i kRoundsSize(13, 7);
constexpr std::uint64_t kPhotons = 37;
using Sums = std::vector<std::int64_t>;

/// In the shape of photon mapping: the items of the first round leave a number each behind, the
/// second round puts them in order, and each pixel of the third one sees all of them.
class ThreeRounds final : public Integrator {
 public:
  std::vector<LayerSpec> layers() const override {
    return {LayerSpec{.name = "direct"}, LayerSpec{.name = "indirect"}};
  }
  bool keeps_state() const override { return true; }
  int rounds_in_pass() const override { return 3; }
  void begin_pass(std::uint64_t /*first*/, std::uint64_t /*samples*/, Film& /*film*/) override {
    round_ = 0;
    photons_.assign(kPhotons, 0);
    sum_ = 0;
  }
  void begin_round(int round) override { round_ = round; }
  std::uint64_t items_in_round() const override {
    if (round_ == 0) return kPhotons;
    return round_ == 1 ? 1 : static_cast<std::uint64_t>(kRoundsSize.x * kRoundsSize.y);
  }
  void run_item(std::uint64_t item, std::uint64_t first_sample, std::uint64_t samples, Film& film,
                Counters& counters) override {
    if (on_item) on_item(round_, item, first_sample);
    if (round_ == 0) photons_[item] = 1 + (item * 7919 + first_sample * 104729) % 1000;
    if (round_ == 1) {
      sum_ = std::accumulate(photons_.begin(), photons_.end(), std::uint64_t{0});
      EXPECT_EQ(std::count(photons_.begin(), photons_.end(), 0), 0) << "the barrier was passed";
    }
    if (round_ < 2) return;
    EXPECT_NE(sum_, 0U) << "the barrier was passed";
    const auto width = static_cast<std::uint64_t>(kRoundsSize.x);
    const Vec2i pixel(static_cast<int>(item % width), static_cast<int>(item / width));
    for (std::uint64_t i = first_sample; i < first_sample + samples; ++i) {
      film.add(1, static_cast<int>(i % 4), pixel, Spectrum(static_cast<float>(sum_ % (item + 9))));
      ++counters.samples;
    }
  }
  DevelopScale develop_scale(const LayerSpec& /*layer*/, std::uint64_t samples,
                             std::optional<int> replicate) const override {
    return (replicate ? 4 : 1) / static_cast<double>(samples);
  }
  void save_state(OutputArchive& archive) const override { archive(round_, photons_, sum_); }
  void load_state(InputArchive& archive, std::uint64_t /*samples*/) override {
    archive(round_, photons_, sum_);
  }
  void export_delta(OutputArchive& archive, const WorkSlice& share) override {
    archive(sum_);
    for (std::uint64_t i = 0; i < kPhotons; ++i) {
      if (share.has(i)) archive(photons_[i]);
    }
  }
  void import_delta(InputArchive& archive, const WorkSlice& share) override {
    std::uint64_t sum = 0;
    archive(sum);
    sum_ = std::max(sum_, sum);  // one process alone has run the item of the second round
    for (std::uint64_t i = 0; i < kPhotons; ++i) {
      if (share.has(i)) archive(photons_[i]);
    }
  }

  std::function<void(int round, std::uint64_t item, std::uint64_t first_sample)> on_item;

 private:
  int round_ = 0;
  std::vector<std::uint64_t> photons_;
  std::uint64_t sum_ = 0;
};

Film film_of_rounds() {
  return {kRoundsSize, Box2i(Vec2i(0, 0), kRoundsSize - Vec2i(1, 1)), Filter::box(), 4,
          ThreeRounds().layers()};
}

/// Passes depend on the clock, and what is seen by their photons on them: one sample each.
RenderJobOptions one_sample_a_pass(int threads) {
  RenderJobOptions options;
  options.budget.samples_per_pixel = 8;
  options.pass_seconds = 0.0;
  options.threads = threads;
  return options;
}

Sums sums_of(const Film& film) { return {film.raw().begin(), film.raw().end()}; }

Sums rendered(int threads) {
  ThreeRounds integrator;
  Film film = film_of_rounds();
  RenderJob job(integrator, film, one_sample_a_pass(threads));
  const RenderResult result = job.run();
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.counters.samples, 8U * 13U * 7U);
  EXPECT_EQ(job.snapshot().samples_done, 8.0);
  return sums_of(film);
}

TEST(Rounds, GiveTheSameBitsOnAnyNumberOfThreads) {
  const Sums reference = rendered(1);
  EXPECT_GT(*std::max_element(reference.begin(), reference.end()), 0);
  EXPECT_EQ(rendered(4), reference);
}

TEST(Rounds, GiveTheSameBitsOnAnyNumberOfRanks) {
  for (const int count : {1, 2, 3}) {
    ThreadRanks ranks(count);
    Sums sums;
    std::vector<std::thread> threads;
    threads.reserve(static_cast<std::size_t>(count));
    for (int rank = 0; rank < count; ++rank) {
      threads.emplace_back([&, rank] {
        ThreeRounds integrator;
        Film film = film_of_rounds();
        RenderJobOptions options = one_sample_a_pass(2);
        options.ranks = &ranks.member(rank);
        RenderJob job(integrator, film, options);
        job.run();
        if (rank == 0) sums = sums_of(job.film());
      });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(sums, rendered(1)) << count << " ranks";
  }
}

/// The second signal cuts a pass in each of its rounds; another integrator goes on.
TEST(Rounds, GiveTheSameBitsAfterAResumeInAnyOfThem) {
  for (const int round : {0, 1, 2}) {
    InterruptCount interrupts{0};
    ThreeRounds integrator;
    integrator.on_item = [&](int now, std::uint64_t item, std::uint64_t first_sample) {
      if (now == round && first_sample == 3 && item == (round == 1 ? 0 : 20)) interrupts = 2;
    };
    Film film = film_of_rounds();
    RenderJobOptions options = one_sample_a_pass(2);
    options.interrupts = &interrupts;
    RenderJob cut(integrator, film, options);
    EXPECT_FALSE(cut.run().complete);
    ASSERT_TRUE(cut.state().partial.has_value());
    // An item that is the last of its round ends it: the pass waits in the next one.
    EXPECT_EQ(cut.state().partial->round, round == 1 ? 2 : round);
    EXPECT_EQ(cut.state().samples_per_pixel, 3U);

    ThreeRounds other;
    unarchive(archived([&](OutputArchive& archive) { integrator.save_state(archive); }),
              [&](InputArchive& archive) { other.load_state(archive, 3); });
    options.interrupts = nullptr;
    options.resumed = cut.state();
    RenderJob rest(other, film, options);
    EXPECT_TRUE(rest.run().complete);
    EXPECT_EQ(sums_of(film), rendered(1)) << "cut in round " << round;
  }
}

TEST(Rounds, OfAnotherMethodCannotBeGoneOnWith) {
  ThreeRounds integrator;
  Film film = film_of_rounds();
  RenderJobOptions options = one_sample_a_pass(1);
  integrator.begin_pass(0, 1, film);
  options.resumed.emplace();
  options.resumed->partial =
      PartialPass{.samples = 1, .done = std::vector<std::uint8_t>(kPhotons), .rounds = 2};
  EXPECT_THROW(RenderJob(integrator, film, options), IoError);
}

}  // namespace
}  // namespace ajar
