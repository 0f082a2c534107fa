#include "session/output/picture_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "integrator/montecarlo/scene_features.h"
#include "post/display.h"

namespace ajar {
namespace {

/// Makes each picture even, as bright as it is on average, and counts what it was given.
class Evener final : public Denoiser {
 public:
  std::string name() const override { return "evener 1"; }
  std::uint64_t memory_bytes(std::uint64_t pixels) const override { return pixels; }
  Features prepare(Vec2i /*size*/, Features features) const override {
    ++prepared;
    return features;
  }
  std::optional<std::vector<float>> filter(const NoisyPicture& picture, const Features& features,
                                           const Progress& progress) const override {
    albedo = features.albedo;
    largest = std::max(largest, picture.size.x * picture.size.y);
    if (picture.roughly)
      roughly_filtered.emplace_back(picture.colour.begin(), picture.colour.end());
    ++(picture.roughly ? rough_runs : fine_runs);
    if (progress && !progress(0.5)) return std::nullopt;
    const float sum = std::accumulate(picture.colour.begin(), picture.colour.end(), 0.F);
    return std::vector<float>(picture.colour.size(),
                              sum / static_cast<float>(picture.colour.size()));
  }
  mutable int prepared = 0;
  mutable int rough_runs = 0;
  mutable int fine_runs = 0;
  mutable int largest = 0;  ///< pixels
  mutable Replicates roughly_filtered;
  mutable std::vector<float> albedo;
};

constexpr Vec2i kFilteredSize{40, 30};
constexpr std::size_t kValues = std::size_t{3} * 40 * 30;

std::vector<float> even(float value) { return std::vector<float>(kValues, value); }
/// Black and twice that, pixel by pixel: a mean of 1.
std::vector<float> chequered() {
  std::vector<float> values(kValues);
  for (std::size_t i = 0; i < kValues; ++i) values[i] = (i / 3 + i / 120) % 2 == 0 ? 0.F : 2.F;
  return values;
}

Picture picture_of(std::vector<float> pixels) {
  Picture picture;
  picture.resolution = kFilteredSize;
  picture.crop = Box2i({0, 0}, kFilteredSize - Vec2i(1, 1));
  picture.layers.push_back({"", 3, std::move(pixels)});
  return picture;
}

std::optional<Features> nothing(std::uint32_t /*rays*/, const Denoiser::Progress& /*progress*/) {
  return Features();
}

const std::vector<float>& layer_of(const Picture& picture, const std::string& name) {
  return std::find_if(picture.layers.begin(), picture.layers.end(),
                      [&](const Picture::Layer& layer) { return layer.name == name; })
      ->pixels;
}

TEST(PictureFilter, AddsLayersAndLooksAtTheSceneOnce) {
  const auto evener = std::make_shared<Evener>();
  int looks = 0;
  PictureFilter filter(evener, [&](std::uint32_t /*rays*/, const Denoiser::Progress&) {
    ++looks;
    return Features{even(0.25F), even(0.5F)};
  });
  EXPECT_TRUE(filter.features().empty());
  for (int i = 0; i < 2; ++i) {
    Picture picture = picture_of(chequered());
    ASSERT_TRUE(filter.add_layers(picture));
    EXPECT_EQ(picture.layers.front().pixels, chequered()) << "as it was rendered";
    EXPECT_EQ(shown_layer(picture).name, kDenoisedLayer);
    EXPECT_EQ(shown_layer(picture).pixels, even(1.F));
    EXPECT_EQ(layer_of(picture, kFeatureAlbedo), even(0.25F));
    EXPECT_EQ(layer_of(picture, kFeatureNormal), even(0.5F));
    EXPECT_EQ(picture.metadata.at("ajar:denoiser"), "evener 1");
  }
  EXPECT_EQ(looks, 1);
  EXPECT_EQ(evener->prepared, 1);
  EXPECT_EQ(evener->albedo, even(0.25F));
  EXPECT_EQ(filter.features().albedo, even(0.25F));
}

/// Finished pictures hang on their samples alone, whatever was looked at before.
TEST(PictureFilter, KnowsFeaturesByTheRaysOfAFinishedPicture) {
  std::vector<std::uint32_t> looks;
  const auto evener = std::make_shared<Evener>();
  PictureFilter filter(evener, [&](std::uint32_t rays, const Denoiser::Progress&) {
    looks.push_back(rays);
    const std::vector<float> shown = even(static_cast<float>(rays));
    return Features{shown, shown};
  });
  PictureEstimates estimates{Replicates(4, even(1.F)), {}};
  for (const std::uint64_t samples : {320U, 327U, 4U, 1000U}) {
    estimates.samples = samples;
    Picture picture = picture_of(even(1.F));
    ASSERT_TRUE(filter.add_best_layers(picture, estimates));
    EXPECT_EQ(evener->albedo, even(static_cast<float>(feature_rays(samples))));
    EXPECT_EQ(layer_of(picture, kFeatureNormal), evener->albedo);
  }
  EXPECT_EQ(looks, (std::vector<std::uint32_t>{40, 16, 64}));
}

TEST(PictureFilter, FiltersTheUnfilteredPictureAndBothEstimates) {
  const auto evener = std::make_shared<Evener>();
  PictureFilter filter(evener, nothing);
  Picture picture = picture_of(even(1.F));
  ASSERT_TRUE(
      filter.add_best_layers(picture, {Replicates(4, even(1.F)), Replicates(4, even(1.F))}));
  EXPECT_EQ(evener->fine_runs, 2);
  EXPECT_EQ(evener->rough_runs, 4);
  EXPECT_EQ(layer_of(picture, kDenoisedLayer), even(1.F));
  EXPECT_EQ(denoised_error(picture), 0.0);
}

/// Filtered pictures are made of boxes; the mixture also has the picture itself.
TEST(PictureFilter, FiltersBoxesAndMixesThemWithThePicture) {
  const auto evener = std::make_shared<Evener>();
  PictureFilter filter(evener, nothing);
  Picture passing = picture_of(even(1.F));
  passing.for_filters = even(2.F);
  ASSERT_TRUE(filter.add_layers(passing));
  EXPECT_EQ(layer_of(passing, kDenoisedLayer), even(2.F));

  // Filtered boxes are twice what the picture's replicates agree on.
  Picture picture = picture_of(even(1.F));
  picture.for_filters = even(2.F);
  const PictureEstimates estimates{
      .replicates = Replicates(4, even(1.F)), .others = {}, .boxes = Replicates(4, even(2.F))};
  ASSERT_TRUE(filter.add_best_layers(picture, estimates));
  EXPECT_EQ(layer_of(picture, kDenoisedLayer), even(1.F));
}

/// Parts as `mix_estimates` wants them.
TEST(PictureFilter, FiltersTheHalvesThatAreEveryOtherReplicate) {
  const auto evener = std::make_shared<Evener>();
  PictureFilter filter(evener, nothing);
  Picture picture = picture_of(even(2.5F));
  ASSERT_TRUE(filter.add_best_layers(picture, {{even(1.F), even(2.F), even(3.F), even(4.F)}, {}}));
  EXPECT_EQ(evener->roughly_filtered, Replicates({even(2.F), even(3.F)}));
}

TEST(PictureFilter, ExpectsItsTimeFromCornersOfThePicture) {
  for (const bool has_others : {false, true}) {
    const auto evener = std::make_shared<Evener>();
    const PictureFilter filter(evener, nothing);
    EXPECT_GE(filter.expected_seconds({640, 480}, has_others), 0.0);
    EXPECT_EQ(evener->rough_runs, 2 * evener->fine_runs);
    EXPECT_EQ(evener->fine_runs, has_others ? 6 : 3);
    EXPECT_EQ(evener->largest, 96 * 96);
    EXPECT_EQ(evener->albedo.size(), std::size_t{3} * 96 * 96);
    EXPECT_EQ(evener->prepared, 3);
    EXPECT_TRUE(PictureFilter(evener, nothing).features().empty());
  }
  // Smaller than any corner.
  const auto evener = std::make_shared<Evener>();
  EXPECT_GE(PictureFilter(evener, nothing).expected_seconds({3, 2}, false), 0.0);
  EXPECT_EQ(evener->largest, 6);
}

TEST(PictureFilter, ShowsWhatItsReplicatesAgreeOn) {
  // All replicates have the squares, which are no noise.
  PictureFilter filter(std::make_shared<Evener>(), nothing);
  Picture picture = picture_of(chequered());
  ASSERT_TRUE(filter.add_best_layers(picture, {Replicates(4, chequered()), {}}));
  EXPECT_EQ(layer_of(picture, kDenoisedLayer), chequered());
}

TEST(PictureFilter, TakesTheOtherEstimateWhereItIsBetter) {
  // The picture's replicates are 1 on average, and far apart; those of its other estimate agree.
  PictureFilter filter(std::make_shared<Evener>(), nothing);
  Picture picture = picture_of(even(1.2F));
  const Replicates replicates = {even(0.1F), even(2.7F), even(0.F), even(2.F)};
  ASSERT_TRUE(filter.add_best_layers(picture, {replicates, Replicates(4, even(1.F))}));
  EXPECT_NEAR(layer_of(picture, kDenoisedLayer)[0], 1.F, 0.02F);
}

TEST(PictureFilter, DoesNotTakeTheOtherEstimateWhereItMissesLight) {
  PictureFilter filter(std::make_shared<Evener>(), nothing);
  Picture picture = picture_of(even(1.F));
  const Replicates replicates = {even(0.9F), even(1.1F), even(0.9F), even(1.1F)};
  ASSERT_TRUE(filter.add_best_layers(picture, {replicates, Replicates(4, even(0.7F))}));
  EXPECT_NEAR(layer_of(picture, kDenoisedLayer)[0], 1.F, 0.02F);
}

TEST(PictureFilter, WithFewReplicatesMixesNothing) {
  const auto evener = std::make_shared<Evener>();
  PictureFilter filter(evener, nothing);
  Picture picture = picture_of(chequered());
  ASSERT_TRUE(filter.add_best_layers(picture, {Replicates(3, chequered()), {}}));
  EXPECT_EQ(layer_of(picture, kDenoisedLayer), even(1.F));
  EXPECT_EQ(evener->rough_runs, 0);
  EXPECT_FALSE(denoised_error(picture));
}

TEST(PictureFilter, TakesValuesThatAreNoNumbersAsBlack) {
  PictureFilter filter(std::make_shared<Evener>(), nothing);
  std::vector<float> broken = even(1.F);
  broken[100] = std::numeric_limits<float>::quiet_NaN();
  broken[500] = std::numeric_limits<float>::infinity();
  Picture picture = picture_of(broken);
  ASSERT_TRUE(filter.add_best_layers(picture, {Replicates(4, broken), {}}));
  for (const char* name : {kDenoisedLayer, kDenoisedError}) {
    const std::vector<float>& pixels = layer_of(picture, name);
    EXPECT_TRUE(std::all_of(pixels.begin(), pixels.end(), [](float v) { return std::isfinite(v); }))
        << name;
  }
}

TEST(PictureFilter, TellsHowFarItIs) {
  PictureFilter filter(std::make_shared<Evener>(), nothing);
  Picture picture = picture_of(chequered());
  std::vector<double> told;
  ASSERT_TRUE(filter.add_best_layers(picture, {Replicates(4, chequered()), {}}, [&](double done) {
    told.push_back(done);
    return true;
  }));
  EXPECT_EQ(told.size(), 3U);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_NEAR(told.front(), 1.5 / 4, 1e-9) << "after the features";
  EXPECT_NEAR(told.back(), 3.5 / 4, 1e-9);
}

TEST(PictureFilter, LeavesAPictureAsItWasWhereverItIsStopped) {
  const PictureEstimates estimates{Replicates(4, chequered()), Replicates(4, chequered())};
  for (int stop = 0; stop < 6; ++stop) {
    PictureFilter filter(std::make_shared<Evener>(), nothing);
    Picture picture = picture_of(chequered());
    int told = 0;
    EXPECT_FALSE(filter.add_best_layers(picture, estimates, [&](double) { return told++ < stop; }));
    EXPECT_EQ(picture.layers.size(), 1U) << stop;
    EXPECT_EQ(&shown_layer(picture), &picture.layers.front());
  }
  // While it looks at the scene, which it does again then.
  int looks = 0;
  PictureFilter filter(std::make_shared<Evener>(), [&](std::uint32_t, const Denoiser::Progress&) {
    return ++looks == 1 ? std::nullopt : std::optional(Features());
  });
  Picture picture = picture_of(chequered());
  EXPECT_FALSE(filter.add_layers(picture));
  EXPECT_EQ(picture.layers.size(), 1U);
  EXPECT_TRUE(filter.add_layers(picture));
}

TEST(PictureFilter, MakesPicturesForTheEye) {
  Picture picture = picture_of(even(1.F));
  picture.layers.push_back({kDenoisedLayer, 3, even(0.F)});
  EXPECT_EQ(displayed(picture, {}).layers.front().pixels[0], 0.F);
  picture.layers.pop_back();
  EXPECT_FLOAT_EQ(displayed(picture, {}).layers.front().pixels[0], 1.F);
}

}  // namespace
}  // namespace ajar
