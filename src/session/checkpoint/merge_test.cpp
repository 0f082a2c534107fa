#include "session/checkpoint/merge.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "session/job/render_job.h"
#include "session/testing/test_integrator.h"
#include "session/version.h"

namespace ajar {
namespace {

const Vec2i kMergedSize(13, 7);
constexpr int kMergedReplicates = 4;

NamedCheckpoint part(std::uint64_t seed, std::uint64_t samples, WorkSlice share = {},
                     double magnitude = 1.0, bool uneven = false) {
  NamedCheckpoint named{"part-" + std::to_string(seed) + "-" + std::to_string(share.index), {}};
  Checkpoint& checkpoint = named.checkpoint;
  checkpoint.version = version();
  RenderSettings& settings = checkpoint.render.settings;
  settings.resolution = kMergedSize;
  settings.crop = Box2i(Vec2i(0, 0), kMergedSize - Vec2i(1, 1));
  settings.replicates = kMergedReplicates;
  settings.seed = seed;
  checkpoint.render.spec.share = share;
  TestIntegrator integrator(kMergedSize, kMergedReplicates);
  integrator.uneven = uneven;
  integrator.first_number = seed * 100000;
  std::vector<LayerSpec> layers = integrator.layers();
  for (LayerSpec& layer : layers) layer.magnitude = magnitude;
  Film film(kMergedSize, settings.crop, Filter::box(), kMergedReplicates, layers);
  RenderJobOptions options;
  options.budget.samples_per_pixel = samples;
  options.threads = 2;
  options.share = share;
  RenderJob job(integrator, film, options);
  job.run();
  checkpoint.job = job.state();
  checkpoint.layers = layers;
  checkpoint.scales = development_of(film, integrator, samples);
  checkpoint.sums.assign(film.raw().begin(), film.raw().end());
  return named;
}

template <typename... Parts>
Checkpoint merged(Parts&&... parts) {
  std::vector<NamedCheckpoint> list;
  (list.push_back(std::forward<Parts>(parts)), ...);
  return merge(std::move(list), false);
}

std::vector<float> picture(Checkpoint checkpoint) {
  const std::uint64_t samples = checkpoint.job.samples_per_pixel;
  const Development scales = checkpoint.scales;
  const Film film = film_of(checkpoint, Filter::box(), "");
  return develop(film, scales, samples, 1.0, {}).layers.front().pixels;
}

TEST(Merge, SharesGiveTheBitsOfTheWhole) {
  const Checkpoint whole = part(3, 24).checkpoint;
  const Checkpoint sum = merged(part(3, 24, {2, 3}), part(3, 24, {0, 3}), part(3, 24, {1, 3}));
  EXPECT_EQ(sum.sums, whole.sums);
  EXPECT_EQ(sum.job.samples_per_pixel, 24U);
  EXPECT_EQ(sum.job.counters.samples, whole.job.counters.samples);
  EXPECT_EQ(sum.render.spec.share, WorkSlice{});
  EXPECT_TRUE(sum.merged.empty()) << "it can go on";
}

TEST(Merge, SeedsGiveTheMeanWeightedByTheirSamples) {
  // Different magnitudes, as pilots of different seeds find them.
  const Checkpoint a = part(1, 8, {}, 0.3).checkpoint;
  const Checkpoint b = part(2, 24, {}, 1.7).checkpoint;
  const Checkpoint sum = merged(part(1, 8, {}, 0.3), part(2, 24, {}, 1.7));
  const std::vector<float> x = picture(a);
  const std::vector<float> y = picture(b);
  const std::vector<float> mean = picture(sum);
  for (std::size_t i = 0; i < mean.size(); ++i) {
    EXPECT_NEAR(mean[i], 0.25F * x[i] + 0.75F * y[i], 1e-6F);
  }
  EXPECT_EQ(sum.job.samples_per_pixel, 32U);
  ASSERT_EQ(sum.merged.size(), 2U);
  EXPECT_EQ(sum.merged[1].seed, 2U);
}

TEST(Merge, OrderDoesNotMatter) {
  const Checkpoint one = merged(part(1, 8, {}, 0.3), part(2, 24, {}, 1.7), part(3, 8));
  const Checkpoint other = merged(part(3, 8), part(2, 24, {}, 1.7), part(1, 8, {}, 0.3));
  EXPECT_EQ(one.sums, other.sums);
}

TEST(Merge, ErrorFallsWithTheSamples) {
  const double alone = merged(part(1, 64)).job.relative_error.value().value;
  const Checkpoint sum = merged(part(1, 64), part(2, 64), part(3, 64), part(4, 64));
  // Based on 273 values with 3 degrees of freedom each: standard error about 3 %.
  EXPECT_NEAR(sum.job.relative_error.value().value / alone, 0.5, 0.08);
}

TEST(Merge, UnequalReplicatesAreScaledEachByTheirOwnSamples) {
  // 5 samples each: replicate 0 has 4 of the 10, the others 2.
  const Checkpoint sum = merged(part(1, 8), part(2, 8));
  Checkpoint a = part(1, 8).checkpoint;
  a.scales.replicates[0] = {0.5, 1.0, 1.0, 1.0};
  const Development both = development_of_sum(a.scales, a.scales);
  EXPECT_DOUBLE_EQ(both.replicates[0][0].factor, 0.25);
  EXPECT_DOUBLE_EQ(both.replicates[0][1].factor, 0.5);
  EXPECT_DOUBLE_EQ(sum.scales.whole[0].factor, 1.0 / 16.0);
}

TEST(Merge, PixelsAreWeightedEachByTheirOwnSamples) {
  const std::vector<float> x = picture(part(1, 8, {}, 1.0, true).checkpoint);
  const std::vector<float> y = picture(part(2, 24, {}, 1.0, true).checkpoint);
  const std::vector<float> mean =
      picture(merged(part(1, 8, {}, 1.0, true), part(2, 24, {}, 1.0, true)));
  for (std::size_t i = 0; i < mean.size(); ++i) {
    const auto samples = [&](std::size_t seed) {
      return static_cast<float>(1 + (seed * 100000 + i / 3) % 3);
    };
    const float weight = 8.F * samples(1) / (8.F * samples(1) + 24.F * samples(2));
    EXPECT_NEAR(mean[i], weight * x[i] + (1.F - weight) * y[i], 1e-6F);
  }
}

TEST(Merge, SharesOfUnevenPixelsGiveTheBitsOfTheWhole) {
  const Checkpoint whole = part(3, 24, {}, 1.0, true).checkpoint;
  const Checkpoint sum = merged(part(3, 24, {1, 2}, 1.0, true), part(3, 24, {0, 2}, 1.0, true));
  EXPECT_EQ(picture(sum), picture(whole));
}

TEST(Merge, MergesCanBeMergedAgain) {
  NamedCheckpoint two{"two", merged(part(1, 8), part(2, 8))};
  NamedCheckpoint one{"one", merged(part(3, 8))};
  const Checkpoint three = merged(std::move(two), std::move(one));
  EXPECT_EQ(three.sums, merged(part(1, 8), part(2, 8), part(3, 8)).sums);
  EXPECT_EQ(three.merged.size(), 3U);
}

template <typename... Parts>
std::string refusal(Parts&&... parts) {
  try {
    merged(std::forward<Parts>(parts)...);
  } catch (const UsageError& error) {
    return error.what();
  }
  return {};
}

TEST(Merge, RefusesWhatMakesNoSense) {
  const auto says = [](const std::string& text, const char* part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  says(refusal(part(1, 8), part(1, 8)), "same samples");
  says(refusal(part(1, 8), part(1, 16)), "same samples");
  says(refusal(part(1, 8, {0, 2})), "share 2/2 of seed 1 is missing");
  says(refusal(part(1, 8, {1, 2})), "share 1/2 of seed 1 is missing");
  says(refusal(part(1, 8, {0, 3}), part(1, 8, {2, 3})), "share 2/3 of seed 1 is missing");
  says(refusal(part(1, 8, {0, 2}), part(1, 8, {0, 2}), part(1, 8, {1, 2})), "twice");
  says(refusal(part(1, 8, {0, 2}), part(1, 8, {1, 3})), "share of 3");
  says(refusal(part(1, 8, {0, 2}), part(1, 12, {1, 2})), "12 samples per pixel");
  NamedCheckpoint two{"two", merged(part(1, 8), part(2, 8))};
  says(refusal(std::move(two), part(2, 8)), "seed 2 is in it");
  const auto changed = [](auto change) {
    NamedCheckpoint other = part(2, 8);
    change(other.checkpoint);
    return refusal(part(1, 8), std::move(other));
  };
  says(changed([](Checkpoint& c) { c.render.scene_hash = 5; }), "another scene");
  says(changed([](Checkpoint& c) { c.render.integrator = "bdpt"; }), "integrator");
  says(changed([](Checkpoint& c) { c.render.settings.max_depth = 3; }), "depth");
  says(changed([](Checkpoint& c) { c.render.settings.replicates = 2; }), "replicates");
  says(changed([](Checkpoint& c) { c.layers.pop_back(); }), "layers");
  says(changed([](Checkpoint& c) { c.version = "0.0.1"; }), "0.0.1");
  says(changed([](Checkpoint& c) { c.job.partial.emplace(); }), "cut short");
  says(changed([](Checkpoint& c) { c.job.samples_per_pixel = 0; }), "no samples");
}

}  // namespace
}  // namespace ajar
