#include "scene/texture/texture.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/warnings.h"
#include "scene/desc/models.h"
#include "scene/desc/scene_desc.h"
#include "scene/testing/texture_points.h"

namespace ajar {
namespace {

using desc::TextureRef;
using testing::at_uv;

SurfacePoint at_position(const Vec3& p) {
  SurfacePoint point{};
  point.p = p;
  return point;
}

/// Builds a description's textures and evaluates the last.
class TextureTest : public ::testing::Test {
 protected:
  desc::TextureId add(std::string_view model, desc::Node::Given given = {}) {
    scene_.textures.emplace_back().node = desc::texture_node(model, given);
    return static_cast<desc::TextureId>(scene_.textures.size()) - 1;
  }
  desc::TextureId add_constant(float r, float g, float b) {
    return add("constant", {{"value", Vec3(r, g, b)}});
  }
  desc::TextureId add_product(const desc::Value& first, const desc::Value& second) {
    return add("product", {{"first", first}, {"second", second}});
  }
  desc::TextureId add_mix(desc::TextureId first, desc::TextureId second, desc::TextureId amount) {
    return add("mix", {{"first", TextureRef{first}},
                       {"second", TextureRef{second}},
                       {"amount", TextureRef{amount}}});
  }
  const Texture& built() {
    textures_ = build_textures(scene_, warnings_);
    return *textures_.back();
  }
  desc::SceneDesc scene_;
  Warnings warnings_;
  TextureList textures_;
};

void expect_rgb(const Spectrum& s, float r, float g, float b) {
  EXPECT_NEAR(s[0], r, 1e-5F);
  EXPECT_NEAR(s[1], g, 1e-5F);
  EXPECT_NEAR(s[2], b, 1e-5F);
}

TEST_F(TextureTest, ThresholdIsOneFromItsEdgeOn) {
  const auto edge = [&](float at) {
    const desc::TextureId value = add_constant(0.25F, 1.F, 1.F);
    add("threshold", {{"value", TextureRef{value}}, {"edge", at}});
    return built().eval_float(at_uv(0.F, 0.F));
  };
  EXPECT_EQ(edge(0.2F), 1.F);
  EXPECT_EQ(edge(0.25F), 1.F);
  EXPECT_EQ(edge(0.3F), 0.F);
}

TEST_F(TextureTest, ProductMultipliesAndFoldsConstants) {
  const auto a = add_constant(0.5F, 1.F, 2.F);
  const auto b = add_constant(0.5F, 0.25F, 3.F);
  add_product(TextureRef{a}, TextureRef{b});
  const Texture& texture = built();
  ASSERT_NE(texture.constant(), nullptr);
  expect_rgb(*texture.constant(), 0.25F, 0.25F, 6.F);
}

TEST_F(TextureTest, MixWeighsWithItsAmount) {
  const auto a = add_constant(1.F, 0.F, 0.F);
  const auto b = add_constant(0.F, 0.F, 1.F);
  const auto amount = add(
      "bilinear", {{"v00", Vec3(0.F)}, {"v01", Vec3(0.F)}, {"v10", Vec3(1.F)}, {"v11", Vec3(1.F)}});
  add_mix(a, b, amount);
  const Texture& texture = built();
  EXPECT_EQ(texture.constant(), nullptr);
  expect_rgb(texture.eval(at_uv(0.25F, 0.9F)), 0.75F, 0.F, 0.25F);
  EXPECT_NEAR(texture.eval_float(at_uv(0.25F, 0.9F)), 0.75F, 1e-6F);
}

/// Error of building the scene, or "no error".
std::string error_of(const desc::SceneDesc& scene) {
  Warnings warnings;
  try {
    build_textures(scene, warnings);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

TEST_F(TextureTest, ExponentialNestingIsRefused) {
  // Each looks up the one before twice, which 2^n lookups come of.
  auto last = add("bilinear");
  for (int level = 0; level < 11; ++level) last = add_product(TextureRef{last}, TextureRef{last});
  EXPECT_EQ(error_of(scene_), "no error");
  for (int level = 0; level < 40; ++level) last = add_mix(last, last, last);
  scene_.textures[12].where = {std::make_shared<const std::string>("a.pbrt"), 5, 1};
  const std::string error = error_of(scene_);
  EXPECT_NE(error.find("looks up"), std::string::npos) << error;
  EXPECT_NE(error.find("at most 4096 are possible"), std::string::npos) << error;
  EXPECT_EQ(error.find("a.pbrt:5:1: "), 0U) << error;
}

TEST_F(TextureTest, ChainsOfTexturesMayNotBeDeeperThanTheStack) {
  const auto constant = add_constant(0.5F, 0.5F, 0.5F);
  auto last = add("uv");
  for (int level = 0; level < 1000; ++level) {
    last = add("checkerboard", {{"first", TextureRef{last}}, {"second", TextureRef{constant}}});
  }
  EXPECT_EQ(error_of(scene_), "no error") << "a checkerboard looks up only one of its two";
  for (int level = 0; level < 200000; ++level)
    last = add_product(TextureRef{last}, TextureRef{constant});
  EXPECT_NE(error_of(scene_).find("at most 4096"), std::string::npos);
}

TEST_F(TextureTest, TexturesOfConstantsAreConstantsHoweverDeep) {
  auto last = add_constant(0.5F, 1.F, 0.F);
  for (int level = 0; level < 5000; ++level) last = add_mix(last, last, last);
  ASSERT_NE(built().constant(), nullptr);
  expect_rgb(*textures_.back()->constant(), 0.5F, 1.F, 0.F);
}

TEST_F(TextureTest, BilinearInterpolatesItsCorners) {
  add("bilinear", {{"v00", Vec3(0, 0, 0)},
                   {"v01", Vec3(1, 0, 0)},
                   {"v10", Vec3(0, 1, 0)},
                   {"v11", Vec3(0, 0, 1)}});
  const Texture& texture = built();
  expect_rgb(texture.eval(at_uv(0.F, 1.F)), 1.F, 0.F, 0.F);
  expect_rgb(texture.eval(at_uv(1.F, 0.F)), 0.F, 1.F, 0.F);
  expect_rgb(texture.eval(at_uv(0.25F, 0.5F)), 0.375F, 0.125F, 0.125F);
}

TEST_F(TextureTest, CheckerboardAlternatesAlsoBelowZero) {
  const auto a = add_constant(1.F, 1.F, 1.F);
  const auto b = add_constant(0.F, 0.F, 0.F);
  add("checkerboard",
      {{"first", TextureRef{a}}, {"second", TextureRef{b}}, {"scale_u", 4.F}, {"scale_v", 4.F}});
  const Texture& texture = built();
  EXPECT_EQ(texture.eval_float(at_uv(0.1F, 0.1F)), 1.F);
  EXPECT_EQ(texture.eval_float(at_uv(0.3F, 0.1F)), 0.F);
  EXPECT_EQ(texture.eval_float(at_uv(0.3F, 0.3F)), 1.F);
  EXPECT_EQ(texture.eval_float(at_uv(-0.1F, 0.1F)), 0.F);
  EXPECT_EQ(texture.eval_float(at_uv(-0.1F, -0.1F)), 1.F);
  EXPECT_EQ(texture.eval_float(at_uv(1e30F, NAN)), texture.eval_float(at_uv(1e30F, NAN)));
}

TEST_F(TextureTest, SolidCheckerboardUsesItsOwnSpace) {
  Mat4 half;
  half.setScale(0.5);
  add("solid_checkerboard", {{"world_to_texture", std::make_shared<const Mat4>(half)}});
  const Texture& texture = built();
  EXPECT_EQ(texture.eval_float(at_position({1.F, 1.F, 1.F})), 1.F);
  EXPECT_EQ(texture.eval_float(at_position({3.F, 1.F, 1.F})), 0.F);
  EXPECT_EQ(texture.eval_float(at_position({3.F, 1.F, -1.F})), 1.F);
}

TEST_F(TextureTest, UvShowsFractionsOfItsMapping) {
  add("uv", {{"scale_u", 2.F}, {"offset_u", 0.1F}, {"offset_v", -0.25F}});
  expect_rgb(built().eval(at_uv(0.7F, 0.F)), 0.5F, 0.75F, 0.F);
}

TEST_F(TextureTest, MappingsFollowTheirDefinitions) {
  Mat4 move;
  move.setTranslation(Vec3d(-1.0, 0.0, 0.0));
  add("uv", {{"mapping", "spherical"}, {"world_to_texture", std::make_shared<const Mat4>(move)}});
  // From (1,0,0): straight along +y is θ = π/2, φ = π/2.
  expect_rgb(built().eval(at_position({1.F, 5.F, 0.F})), 0.5F, 0.25F, 0.F);
  expect_rgb(built().eval(at_position({1.F, -5.F, 0.F})), 0.5F, 0.75F, 0.F);

  add("uv", {{"mapping", "cylindrical"}});
  expect_rgb(built().eval(at_position({0.F, 3.F, 4.F})), 0.75F, 0.8F, 0.F);
  add("uv", {{"mapping", "cylindrical"}, {"height", "place"}});
  expect_rgb(built().eval(at_position({0.F, 3.F, 4.375F})), 0.75F, 0.375F, 0.F);

  add("uv", {{"mapping", "planar"},
             {"axis_u", Vec3(0.5F, 0, 0)},
             {"axis_v", Vec3(0, 0, 1)},
             {"offset_u", 0.25F}});
  expect_rgb(built().eval(at_position({0.5F, 9.F, 0.125F})), 0.5F, 0.125F, 0.F);
}

TEST_F(TextureTest, DotsAreRoundAndHaveTwoValues) {
  add("dots");
  const Texture& texture = built();
  int inside = 0;
  constexpr int kSteps = 400;
  for (int i = 0; i < kSteps * kSteps; ++i) {
    const int column = i % kSteps;
    const int row = i / kSteps;
    const float v = texture.eval_float(
        at_uv(static_cast<float>(column) * 0.1F, static_cast<float>(row) * 0.1F));
    ASSERT_TRUE(v == 0.F || v == 1.F);
    inside += v == 1.F ? 1 : 0;
  }
  // About half of the cells have a dot of area 0.35² π.
  EXPECT_NEAR(inside / static_cast<double>(kSteps * kSteps), 0.5 * 0.385, 0.08);
}

TEST_F(TextureTest, MarbleHasPlausibleColours) {
  add("marble");
  const Texture& texture = built();
  for (int i = 0; i < 5000; ++i) {
    const float t = static_cast<float>(i) * 0.01F;
    const Spectrum s = texture.eval(at_position({t, 0.7F * t, -0.3F * t}));
    ASSERT_GT(s.min(), 0.2F);
    ASSERT_LT(s.max(), 0.95F);
  }
}

TEST_F(TextureTest, MissingParametersHaveTheirDefaults) {
  add("mix");
  EXPECT_EQ(built().eval_float(at_uv(0.F, 0.F)), 0.5F);
}

TEST_F(TextureTest, ForwardReferencesAreRefused) {
  add_product(TextureRef{1}, Vec3(1.F));
  add_constant(1.F, 1.F, 1.F);
  EXPECT_THROW(build_textures(scene_, warnings_), SceneError);
}

}  // namespace
}  // namespace ajar
