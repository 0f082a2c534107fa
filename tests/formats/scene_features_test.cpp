#include "integrator/montecarlo/scene_features.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "import/pbrt/pbrt_import.h"
#include "session/render/resolved_render.h"

/// Auxiliary buffers of a scene.
namespace ajar {
namespace {

std::unique_ptr<Scene> scene_of(const std::string& world) {
  Warnings warnings;
  desc::SceneDesc description = import_pbrt_text(
      "LookAt 0 0 0  0 0 1  0 1 0\nCamera \"perspective\" \"float fov\" [20]\n"
      "Film \"image\" \"integer xresolution\" [12] \"integer yresolution\" [8]\nWorldBegin\n" +
          world + "\nWorldEnd\n",
      "features.pbrt", ".", warnings);
  return std::make_unique<Scene>(std::move(description), BuildOptions{}, warnings);
}

/// A square of 20 × 20 units in the plane z.
std::string wall(float z) {
  const std::string at = std::to_string(z);
  return "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] \"point P\" [-10 -10 " + at +
         " 10 -10 " + at + " 10 10 " + at + " -10 10 " + at + "]\n";
}

Features features_of(const Scene& scene, const RenderSettings& settings,
                     std::uint32_t rays = feature_rays(0)) {
  return *FeatureTracer(scene, settings).look(rays);
}

struct Look {
  Vec3 albedo;
  Vec3 normal;
};
/// Means over the picture.
Look look_at(const std::string& world) {
  const auto scene = scene_of(world);
  const Features features = features_of(*scene, settings_for(*scene));
  Look mean{Vec3(0.F), Vec3(0.F)};
  const std::size_t pixels = features.albedo.size() / 3;
  EXPECT_EQ(pixels, 96U);
  for (std::size_t i = 0; i < pixels; ++i) {
    for (int c = 0; c < 3; ++c) {
      const std::size_t v = 3 * i + static_cast<std::size_t>(c);
      mean.albedo[c] += features.albedo[v] / static_cast<float>(pixels);
      mean.normal[c] += features.normal[v] / static_cast<float>(pixels);
    }
  }
  return mean;
}

void expect_near(const Vec3& value, const Vec3& wanted, float tolerance = 1e-5F) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(value[c], wanted[c], tolerance) << "channel " << c;
}

constexpr const char* kRed = "Material \"matte\" \"rgb Kd\" [0.8 0.1 0.2]\n";

TEST(SceneFeatures, AreOfTheVisibleSurface) {
  const Look look = look_at(kRed + wall(5.F));
  expect_near(look.albedo, {0.8F, 0.1F, 0.2F});
  expect_near(look.normal, {0.F, 0.F, -1.F});
}

TEST(SceneFeatures, FollowMirrors) {
  const Look look =
      look_at("Material \"mirror\" \"rgb Kr\" [0.5 1 1]\n" + wall(5.F) + kRed + wall(-3.F));
  expect_near(look.albedo, {0.4F, 0.1F, 0.2F});
  expect_near(look.normal, {0.F, 0.F, 1.F});
}

TEST(SceneFeatures, SeeThroughClearGlass) {
  // A block of glass: Fresnel's equations leave 92 % of the background, 8 % is reflected in it.
  const Look look = look_at("Material \"glass\"\n" + wall(4.F) + wall(5.F) + kRed + wall(8.F));
  EXPECT_NEAR(look.albedo[0], 0.92F * 0.8F, 0.02F);
  EXPECT_NEAR(look.normal[2], -0.92F, 0.03F);
}

TEST(SceneFeatures, ShowLightOfLampsUpToWhite) {
  const Look look = look_at(
      "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [7 0.25 0] \"bool twosided\" "
      "\"true\" Material \"matte\" \"rgb Kd\" [0 0 0]\n" +
      wall(5.F) + "AttributeEnd\n");
  expect_near(look.albedo, {1.F, 0.25F, 0.F});
}

TEST(SceneFeatures, ShowGlintsOfAFewRays) {
  // A block of glass mirrors 8 % of a lamp that is twenty times as bright as white: 1.6, cut to 1
  // where one of sixteen rays is mirrored at all. Cut ray by ray, it would be 0.08.
  const Look look = look_at(
      "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [20 2 0] \"bool twosided\" \"true\" "
      "Material \"matte\" \"rgb Kd\" [0 0 0]\n" +
      wall(-3.F) + "AttributeEnd\nMaterial \"glass\"\n" + wall(4.F) + wall(5.F) +
      "Material \"matte\" \"rgb Kd\" [0 0 0]\n" + wall(8.F));
  EXPECT_GT(look.albedo[0], 0.8F);
  EXPECT_NEAR(look.albedo[1], 0.16F, 0.04F);
}

TEST(SceneFeatures, AreBlackWherePathsEndAmongMirrors) {
  const auto scene = scene_of("Material \"mirror\" \"rgb Kr\" [1 1 1]\n" + wall(5.F) + wall(-3.F));
  const Features features = features_of(*scene, settings_for(*scene));
  EXPECT_EQ(*std::max_element(features.albedo.begin(), features.albedo.end()), 0.F);
}

TEST(SceneFeatures, ShowTheSkyWithoutANormal) {
  const Look look = look_at("LightSource \"infinite\" \"rgb L\" [0.25 0.5 4]\n");
  expect_near(look.albedo, {0.25F, 0.5F, 1.F});
  expect_near(look.normal, {0.F, 0.F, 0.F});
}

TEST(SceneFeatures, OfACropAreThoseOfTheWhole) {
  const auto scene = scene_of("Material \"glass\" Translate 0 0 4 Shape \"sphere\"\n" +
                              std::string(kRed) + wall(5.F));
  RenderSettings settings = settings_for(*scene);
  const Features whole = features_of(*scene, settings);
  settings.crop = Box2i({3, 2}, {9, 6});
  const Features part = features_of(*scene, settings);
  ASSERT_EQ(part.albedo.size(), std::size_t{3} * 7 * 5);
  for (int y = 0; y < 5; ++y) {
    for (int i = 0; i < 3 * 7; ++i) {
      const auto inside = static_cast<std::size_t>(3 * 7 * y + i);
      const auto outside = static_cast<std::size_t>(3 * (12 * (y + 2) + 3) + i);
      EXPECT_EQ(part.albedo[inside], whole.albedo[outside]);
      EXPECT_EQ(part.normal[inside], whole.normal[outside]);
    }
  }
}

TEST(SceneFeatures, AreOfOneRayPerPixelInPreviews) {
  // Glass that mirrors or lets through by chance: of sixteen rays few pixels see the same.
  const auto scene = scene_of("Material \"glass\" Translate 0 0 4 Shape \"sphere\"\n" +
                              std::string(kRed) + wall(5.F));
  const RenderSettings settings = settings_for(*scene);
  const Features rough = features_of(*scene, settings, 1);
  int whole = 0;
  for (std::size_t i = 0; i < rough.normal.size(); i += 3) {
    const Vec3 normal(rough.normal[i], rough.normal[i + 1], rough.normal[i + 2]);
    // Normals are of one surface, or of none: a mean of several would be shorter than either.
    whole += std::abs(normal.length() - 1.F) < 1e-5F || normal.length() < 1e-5F ? 1 : 0;
  }
  EXPECT_EQ(whole, static_cast<int>(rough.normal.size() / 3));
}

/// Passes of any length, on any machine, leave the same features.
TEST(SceneFeatures, HangOnTheNumberOfRaysAlone) {
  const auto scene = scene_of("Material \"glass\" Translate 0 0 4 Shape \"sphere\"\n" +
                              std::string(kRed) + wall(5.F));
  const RenderSettings settings = settings_for(*scene);
  const Features whole = features_of(*scene, settings, 24);
  FeatureTracer tracer(*scene, settings);
  // Ended somewhere, and gone on with.
  EXPECT_FALSE(tracer.trace(3, [](double) { return false; }));
  for (const std::uint32_t rays : {2U, 7U, 5U, 24U}) EXPECT_TRUE(tracer.trace(rays));
  EXPECT_EQ(tracer.features().albedo, whole.albedo);
  EXPECT_EQ(tracer.features().normal, whole.normal);
  EXPECT_NE(features_of(*scene, settings, 23).normal, whole.normal);
}

TEST(SceneFeatures, HaveARayForEveryEighthSampleWithinBounds) {
  EXPECT_EQ(feature_rays(0), 16U);
  EXPECT_EQ(feature_rays(327), 40U);
  EXPECT_EQ(feature_rays(1'000'000'000'000), 64U);
}

TEST(SceneFeatures, StopOnRequest) {
  const auto scene = scene_of(kRed + wall(5.F));
  double last = 0.0;
  FeatureTracer tracer(*scene, settings_for(*scene));
  EXPECT_TRUE(tracer.trace(1, [&](double done) {
    last = std::max(last, done);
    return true;
  }));
  EXPECT_EQ(last, 1.0);
  EXPECT_FALSE(tracer.look(2, [](double) { return false; }));
}

}  // namespace
}  // namespace ajar
