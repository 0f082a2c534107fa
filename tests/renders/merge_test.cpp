// Merged renders of different seeds are as good as one long render, and their error bars are right.
#include "session/checkpoint/merge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "mcmc/moments.h"
#include "session/version.h"
#include "support/methods.h"
#include "support/render.h"
#include "support/same_picture.h"
#include "support/small_scenes.h"

namespace ajar {
namespace {

const Scene& room() {
  static const std::vector<test::SmallScene> kScenes = test::small_scenes();
  static const std::unique_ptr<Scene> kRoom =
      test::scene_from(std::find_if(kScenes.begin(), kScenes.end(), [](const auto& scene) {
                         return scene.name == "Room";
                       })->text);
  return *kRoom;
}

NamedCheckpoint checkpoint_of(const test::Render& render, const test::RenderOptions& options) {
  NamedCheckpoint named{"seed-" + std::to_string(options.seed), {}};
  Checkpoint& checkpoint = named.checkpoint;
  checkpoint.version = version();
  const Film& film = *render.film;
  RenderSettings& settings = checkpoint.render.settings;
  settings.resolution = film.resolution();
  settings.crop = film.crop();
  settings.max_depth = options.max_depth;
  settings.seed = options.seed;
  settings.replicates = film.replicates();
  checkpoint.render.integrator = options.integrator;
  checkpoint.job.samples_per_pixel = render.samples;
  checkpoint.layers.assign(film.layers().begin(), film.layers().end());
  checkpoint.scales = development_of(film, *render.integrator, render.samples);
  checkpoint.sums.assign(film.raw().begin(), film.raw().end());
  return named;
}

Checkpoint merge_seeds(test::RenderOptions options, std::uint64_t first_seed,
                       const std::vector<int>& samples) {
  std::vector<NamedCheckpoint> parts;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    options.seed = first_seed + i;
    options.samples = samples[i];
    parts.push_back(checkpoint_of(test::render(room(), options), options));
  }
  return merge(std::move(parts), false);
}

Replicates replicates_of(Checkpoint merged) {
  const Development scales = merged.scales;
  const Film film = film_of(merged, Filter::box(), "");
  std::vector<ScaledLayer> layers;
  for (std::size_t i = 0; i < film.layers().size(); ++i) {
    const LayerSpec& spec = film.layers()[i];
    const std::string& whole = spec.part_of.empty() ? spec.name : spec.part_of;
    if (whole != "direct" && whole != "indirect") continue;
    layers.push_back({static_cast<int>(i), scales.replicates[i]});
  }
  return develop_replicates(film, layers);
}

/// Chains have their own brightness for each seed, and film quanta that hang on it.
TEST(MergedSeeds, HaveTheExpectationOfOneLongRender) {
  for (const std::string& integrator : test::methods_but({})) {
    test::RenderOptions options;
    options.integrator = integrator;
    options.replicates = 8;
    options.max_depth = 6;
    options.samples = 512;
    options.seed = 99;
    const test::Render whole = test::render(room(), options);
    const Replicates merged = replicates_of(merge_seeds(options, 1, {256, 128, 128}));
    // Errors of chains are correlated: replicates differ by more.
    const double power = whole.counters.mutations > 0 ? 0.25 : 0.06;
    test::expect_same(merged, test::replicates_of(whole), *whole.film, power, integrator);
  }
}

TEST(MergedSeeds, AreReplicateByReplicateTheMean) {
  test::RenderOptions options;
  options.integrator = "masked";
  options.parameters = {{"bootstrap", "20000"}};
  // Equal: layers of ordinary Monte Carlo beside chains are weighted by their own samples.
  const std::vector<int> samples = {24, 24, 24};
  const Replicates merged = replicates_of(merge_seeds(options, 1, samples));
  Replicates mean(merged.size(), std::vector<float>(merged.front().size()));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    options.seed = 1 + i;
    options.samples = samples[i];
    const Replicates part = test::replicates_of(test::render(room(), options));
    for (std::size_t r = 0; r < mean.size(); ++r) {
      for (std::size_t j = 0; j < mean[r].size(); ++j) {
        mean[r][j] += part[r][j] * (1.F / 3.F);
      }
    }
  }
  for (std::size_t r = 0; r < mean.size(); ++r) {
    for (std::size_t j = 0; j < mean[r].size(); ++j) {
      ASSERT_NEAR(merged[r][j], mean[r][j], 1e-5F * (1.F + mean[r][j])) << r << ", " << j;
    }
  }
}

/// The mean of the picture scatters around the truth as its error bar says: over 40 merges the mean
/// of z² has the expectation (R − 1) / (R − 3) = 1.15 and a standard error of 0.3. Error bars that
/// are wrong by a factor 1.7 either way (of two seeds: forgotten or counted twice, 1.41, with the
/// chance of a half) fail.
TEST(MergedSeeds, HaveErrorBarsThatAreRight) {
  test::RenderOptions options;
  options.replicates = 16;
  options.max_depth = 4;
  options.samples = 4096;
  options.seed = 5000;
  const Estimate truth = image_mean(test::replicates_of(test::render(room(), options)));
  Moments squares;
  for (int i = 0; i < 40; ++i) {
    const std::uint64_t seed = 100 + 2 * static_cast<std::uint64_t>(i);
    const Estimate mean = image_mean(replicates_of(merge_seeds(options, seed, {16, 48})));
    const double z =
        (mean.value - truth.value) / std::hypot(mean.standard_error, truth.standard_error);
    squares.add(z * z);
  }
  EXPECT_GT(squares.mean(), 0.4);
  EXPECT_LT(squares.mean(), 2.6);
}

}  // namespace
}  // namespace ajar
