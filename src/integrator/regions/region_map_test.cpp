#include "integrator/regions/region_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace ajar {
namespace {

/// A picture of one row, whose regions are runs of equal numbers.
Regions row_of(const std::vector<std::uint32_t>& objects) {
  std::vector<PixelIdentity> identities;
  identities.reserve(objects.size());
  for (const std::uint32_t object : objects) identities.push_back({object, object});
  return connected_regions(Vec2i(static_cast<int>(objects.size()), 1), identities);
}
Plane row_plane(const std::vector<float>& values) {
  Plane plane(Vec2i(static_cast<int>(values.size()), 1));
  plane.values = values;
  return plane;
}

TEST(AggregateNoise, IsOfThePixelsFromTheThresholdOn) {
  const Plane noise = row_plane({0.1F, 0.5F, 0.9F, 0.4F, 0.49F, 0.F, 1.F});
  const auto regions = aggregate_noise(noise, row_of({1, 1, 1, 1, 2, 2, 3}), 0.5F);
  ASSERT_EQ(regions.size(), 3U);
  EXPECT_EQ(regions[0].pixels, 2U);
  EXPECT_FLOAT_EQ(regions[0].mean, 0.7F);
  EXPECT_EQ(regions[0].largest, 0.9F);
  EXPECT_FLOAT_EQ(regions[0].fill(), 0.8F);
  EXPECT_EQ(regions[1].pixels, 0U);
  EXPECT_EQ(regions[1].fill(), 0.F);
  EXPECT_EQ(regions[2].fill(), 1.F);
}

TEST(AggregateNoise, CountsNothingThatIsNoNumber) {
  const auto regions = aggregate_noise(row_plane({std::nanf(""), 0.75F}), row_of({1, 1}), 0.5F);
  EXPECT_EQ(regions[0].pixels, 1U);
  EXPECT_EQ(regions[0].mean, 0.75F);
}

TEST(AggregateNoise, RefusesAPictureOfAnotherSize) {
  EXPECT_THROW(aggregate_noise(Plane(Vec2i(2, 1)), row_of({1, 1, 1}), 0.5F), std::invalid_argument);
  EXPECT_THROW(aggregate_noise(Plane(Vec2i(1, 2)), row_of({1, 1}), 0.5F), std::invalid_argument);
}

TEST(ThresholdMap, IsBinaryAndOneFromTheThresholdOn) {
  const std::vector<RegionNoise> noise = {{}, {1, 0.5F, 0.5F}, {1, 1.F, 1.F}};
  EXPECT_EQ(threshold_map(noise, {}), (std::vector<float>{0.1F, 1.F, 1.F}));
  EXPECT_EQ(threshold_map(noise, {.threshold = 0.6F, .epsilon = 0.F}),
            (std::vector<float>{0.F, 0.F, 1.F}));
  EXPECT_EQ(threshold_map(noise, {.threshold = 0.F}), (std::vector<float>{1.F, 1.F, 1.F}));
}

TEST(ThresholdMap, IsTheSameWhenThePixelsAreThresholdedFirst) {
  // The literal order: S on pixels, then mean and maximum of what is above T.
  const std::vector<float> values = {0.1F, 0.5F, 0.9F, 0.4F, 0.49F, 0.F, 1.F};
  const Regions regions = row_of({1, 1, 1, 1, 2, 2, 3});
  const RegionMapSettings settings;
  std::vector<float> binary;
  binary.reserve(values.size());
  for (const float x : values) binary.push_back(x < settings.threshold ? settings.epsilon : 1.F);
  const auto map = [&](const std::vector<float>& noise) {
    return threshold_map(aggregate_noise(row_plane(noise), regions, settings.threshold), settings);
  };
  EXPECT_EQ(map(values), map(binary));
}

TEST(RegionMap, LetsOneOutlierDecideForItsWholeObject) {
  const Vec2i size(8, 6);
  std::vector<PixelIdentity> identities;
  identities.reserve(48);
  for (int i = 0; i < 48; ++i) identities.push_back({i % 8 < 4 ? 1U : 2U, 1U});
  const Regions regions = connected_regions(size, identities);
  std::vector<float> indirect(48 * 3, 0.5F);
  indirect[(2 * 8 + 1) * 3 + 1] = 20.F;
  // Far below the first: under half of it.
  indirect[(2 * 8 + 6) * 3 + 1] = 9.F;
  for (const int window : {3, 5}) {
    EXPECT_EQ(region_map(indirect, regions, {.window = window}), (std::vector<float>{1.F, 0.1F}));
  }
  EXPECT_EQ(region_map(indirect, regions, {.threshold = 0.4F}), (std::vector<float>{1.F, 1.F}));
}

TEST(RegionMap, OfAPictureWithoutNoiseIsEpsilon) {
  const Regions regions = row_of({1, 1, 2, 2});
  EXPECT_EQ(region_map(std::vector<float>(12, 0.F), regions, {}), (std::vector<float>{0.1F, 0.1F}));
}

/// A toy: one region of nine pixels, each black or, with a small chance p, of value h; Markov
/// chains that know the truth μ = p·h. What the picture is on average, over all pilots.
struct Toy {
  static constexpr int kPixels = 9;
  double p = 0.05;
  double h = 3.0;
  RegionMapSettings settings;

  static std::vector<float> pilot(unsigned outcome, double h) {
    std::vector<float> values(kPixels);
    for (unsigned i = 0; i < kPixels; ++i) {
      if ((outcome >> i & 1U) != 0) values[i] = static_cast<float>(h);
    }
    return values;
  }
  double chance(unsigned outcome) const {
    double product = 1.0;
    for (unsigned i = 0; i < kPixels; ++i) product *= (outcome >> i & 1U) != 0 ? p : 1.0 - p;
    return product;
  }
  /// σ after a pilot; with pictures of one channel.
  double weight(unsigned outcome) const {
    const std::vector<PixelIdentity> same(kPixels, PixelIdentity{1, 1});
    const Regions regions = connected_regions(Vec2i(3, 3), same);
    return static_cast<double>(region_map(pilot(outcome, h), regions, settings).front());
  }
};

TEST(RegionMap, BiasesAPictureThatKeepsThePilotByThePredictedAmount) {
  const Toy toy;
  const double truth = toy.p * toy.h;
  double kept = 0.0;
  double fresh = 0.0;
  for (unsigned outcome = 0; outcome < 1U << Toy::kPixels; ++outcome) {
    const std::vector<float> pilot = Toy::pilot(outcome, toy.h);
    const double weight = toy.weight(outcome);
    double mean = 0.0;
    for (const float value : pilot) mean += static_cast<double>(value) / Toy::kPixels;
    kept += toy.chance(outcome) * (mean * (1.0 - weight) + truth * weight);
    // Samples that know nothing of the map: those of another half, or rendered after the pilot.
    fresh += toy.chance(outcome) * (truth * (1.0 - weight) + truth * weight);
  }
  // A pilot that has seen nothing keeps its black with the weight 1 − ε; one that has seen a
  // spike leaves everything to the chains.
  const double missed = std::pow(1.0 - toy.p, Toy::kPixels);
  const double epsilon = static_cast<double>(toy.settings.epsilon);
  EXPECT_NEAR(kept, truth * (1.0 - (1.0 - epsilon) * missed), 1e-6);
  EXPECT_NEAR(fresh, truth, 1e-12);
}

}  // namespace
}  // namespace ajar
