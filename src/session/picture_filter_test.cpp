#include "session/picture_filter.h"

#include <gtest/gtest.h>

#include "post/display.h"

namespace ajar {
namespace {

/// Makes everything as bright as the first half is, and tells what it was given.
class Painter final : public Denoiser {
 public:
  std::string name() const override { return "painter 1"; }
  std::uint64_t memory_bytes(std::uint64_t pixels) const override { return pixels; }
  Features prepare(Vec2i /*size*/, Features features) const override {
    ++prepared;
    return features;
  }
  std::optional<std::vector<float>> filter(const NoisyPicture& picture, const Features& features,
                                           const Progress& progress) const override {
    albedo = features.albedo;
    if (progress && !progress(0.5)) return std::nullopt;
    const float value = picture.first_half.empty() ? 0.F : picture.first_half[0];
    return std::vector<float>(picture.colour.size(), value);
  }
  mutable int prepared = 0;
  mutable std::vector<float> albedo;
};

Picture grey(float value) {
  Picture picture;
  picture.resolution = {2, 1};
  picture.crop = Box2i({0, 0}, {1, 0});
  picture.layers.push_back({"", 3, std::vector<float>(6, value)});
  return picture;
}

TEST(PictureFilter, AddsLayersAndLooksAtTheSceneOnce) {
  const auto painter = std::make_shared<Painter>();
  int looks = 0;
  PictureFilter filter(painter, [&] {
    ++looks;
    return Features{std::vector<float>(6, 0.25F), std::vector<float>(6, 0.5F)};
  });
  for (int i = 0; i < 2; ++i) {
    Picture picture = grey(1.F);
    const Replicates replicates = {std::vector<float>(6, 2.F), std::vector<float>(6, 4.F),
                                   std::vector<float>(6, 0.F), std::vector<float>(6, 0.F)};
    ASSERT_TRUE(filter.add_layers(picture, {replicates, {}}, {}));
    EXPECT_EQ(picture.layers.front().pixels[0], 1.F) << "the picture stays as it was rendered";
    EXPECT_EQ(shown_layer(picture).name, kDenoisedLayer);
    EXPECT_EQ(shown_layer(picture).pixels[0], 3.F) << "the mean of two of four replicates";
    EXPECT_EQ(picture.layers.at(2).name, kFeatureAlbedo);
    EXPECT_EQ(picture.layers.at(2).pixels[0], 0.25F);
    EXPECT_EQ(picture.metadata.at("ajar:denoiser"), "painter 1");
  }
  EXPECT_EQ(looks, 1);
  EXPECT_EQ(painter->prepared, 1);
  EXPECT_EQ(painter->albedo.at(0), 0.25F);
}

TEST(PictureFilter, LeavesAPictureAsItWasWhenItIsStopped) {
  PictureFilter filter(std::make_shared<Painter>(), [] { return Features(); });
  Picture picture = grey(1.F);
  EXPECT_FALSE(filter.add_layers(picture, {}, [](double) { return false; }));
  EXPECT_EQ(picture.layers.size(), 1U);
  EXPECT_EQ(&shown_layer(picture), &picture.layers.front());
}

TEST(PictureFilter, MakesPicturesForTheEye) {
  Picture picture = grey(1.F);
  picture.layers.push_back({kDenoisedLayer, 3, std::vector<float>(6, 0.F)});
  EXPECT_EQ(displayed(picture, {}).layers.front().pixels[0], 0.F);
  picture.layers.pop_back();
  EXPECT_FLOAT_EQ(displayed(picture, {}).layers.front().pixels[0], 1.F);
}

}  // namespace
}  // namespace ajar
