#include <gtest/gtest.h>

#include <algorithm>

#include "support/render.h"
#include "support/small_scenes.h"

/// Warnings to the user.
namespace ajar {
namespace {

std::vector<Warning> concerns_of(const std::string& scene_text, const std::string& integrator,
                                 std::map<std::string, std::string> parameters = {},
                                 int max_depth = 100, std::uint64_t seed = 1) {
  const auto scene = test::scene_from(scene_text);
  test::RenderOptions options;
  options.integrator = integrator;
  options.samples = 8;
  options.max_depth = max_depth;
  options.seed = seed;
  options.parameters = std::move(parameters);
  return test::render(*scene, options).integrator->findings().concerns;
}

std::string glass_and_metal() { return test::small_scene("GlassAndMetal").text; }

TEST(Concerns, NamePathsBeyondLightTracing) {
  EXPECT_TRUE(concerns_of(test::small_scene("Room").text, "lt").empty());
  const std::vector<Warning> concerns = concerns_of(glass_and_metal(), "lt");
  ASSERT_EQ(concerns.size(), 1U);
  EXPECT_NE(concerns.front().message.find("% of the picture shows mirrors or clear glass"),
            std::string::npos)
      << concerns.front().message;
}

/// A point lamp behind a ball, which throws its light on a larger one.
std::string lamp_behind(const std::string& material) {
  return test::pbrt_scene("LookAt 0 0 -5  0 0 0  0 1 0 Camera \"perspective\"", 16, 16,
                          "LightSource \"point\" \"point from\" [0 3 0] Material \"" + material +
                              "\" Shape \"sphere\" Material \"matte\" Translate 0 0 5 Shape "
                              "\"sphere\" \"float radius\" 3");
}

/// A caustic that only light subpaths can make.
TEST(Concerns, NameTheLightOfPointLampsBehindGlass) {
  const auto of = [](const std::string& material, const char* integrator, int max_depth) {
    return concerns_of(lamp_behind(material), integrator, {}, max_depth);
  };
  const std::vector<Warning> concerns = of("glass", "pt", 3);
  ASSERT_EQ(concerns.size(), 1U);
  EXPECT_NE(concerns.front().message.find("no camera path runs into"), std::string::npos)
      << concerns.front().message;
  EXPECT_TRUE(of("matte", "pt", 3).empty());
  EXPECT_TRUE(of("glass", "pt", 2).empty()) << "lamp, glass, wall, lens";
  for (const char* integrator : {"ibpt", "bdpt", "selective"}) {
    const std::vector<Warning> none = of("glass", integrator, 3);
    EXPECT_TRUE(none.empty()) << integrator << ": " << none.front().message;
  }
}

/// Its pilot meets no such light path with most seeds.
TEST(Concerns, AreNoneOfWhatTheDefaultChooses) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    EXPECT_TRUE(concerns_of(lamp_behind("glass"), "selective", {}, 3, seed).empty()) << seed;
  }
}

/// Caustic seen through the ball.
TEST(Concerns, NameTheLightOfPointLampsThroughGlassOnBothSides) {
  const auto has_it = [](const std::vector<Warning>& concerns) {
    return std::any_of(concerns.begin(), concerns.end(), [](const Warning& warning) {
      return warning.message.find("no technique makes such paths") != std::string::npos;
    });
  };
  for (const char* integrator : {"pt", "lt", "ibpt", "bdpt", "mmlt", "pssmlt"}) {
    EXPECT_TRUE(has_it(concerns_of(lamp_behind("glass"), integrator))) << integrator;
    EXPECT_FALSE(has_it(concerns_of(lamp_behind("glass"), integrator, {}, 3))) << integrator;
    EXPECT_FALSE(has_it(concerns_of(lamp_behind("matte"), integrator))) << integrator;
  }
  for (const char* integrator : {"mlt", "erpt", "selective"}) {
    EXPECT_FALSE(has_it(concerns_of(lamp_behind("glass"), integrator))) << integrator;
  }
  EXPECT_TRUE(has_it(concerns_of(lamp_behind("glass"), "selective", {{"chain", "mmlt"}})));
  EXPECT_TRUE(has_it(concerns_of(lamp_behind("glass"), "masked")));
  EXPECT_TRUE(has_it(concerns_of(lamp_behind("glass"), "erpt", {{"chain", "pssmlt"}})));
}

/// A ball before a lamp that has an extent.
std::string ball_behind(const std::string& material, const std::string& radius) {
  return test::pbrt_scene(
      "LookAt 0 0 -5  0 0 0  0 1 0 Camera \"perspective\"", 16, 16,
      "AttributeBegin AreaLightSource \"diffuse\" Translate 0 1 -3 Shape \"sphere\" \"float "
      "radius\" " +
          radius + " AttributeEnd Material \"" + material +
          "\" Shape \"sphere\" Material \"matte\" Translate 0 0 5 Shape \"sphere\" \"float "
          "radius\" 3");
}

/// Rays run into a small lamp so seldom that replicates agree on a picture without its light.
TEST(Concerns, NameTheLightOfSmallLampsThroughGlass) {
  const auto has = [](const std::vector<Warning>& concerns, const char* text) {
    return std::any_of(concerns.begin(), concerns.end(), [&](const Warning& warning) {
      return warning.message.find(text) != std::string::npos;
    });
  };
  const char* through = "seen in this way is found by chance";
  for (const char* integrator : {"pt", "lt", "ibpt", "bdpt", "mmlt", "pssmlt"}) {
    EXPECT_TRUE(has(concerns_of(ball_behind("glass", "0.01"), integrator), through)) << integrator;
    EXPECT_FALSE(has(concerns_of(ball_behind("glass", "0.01"), integrator, {}, 3), through))
        << integrator;
    EXPECT_FALSE(has(concerns_of(ball_behind("glass", "1"), integrator), through)) << integrator;
    EXPECT_FALSE(has(concerns_of(ball_behind("matte", "0.01"), integrator), through)) << integrator;
  }
  for (const char* integrator : {"mlt", "erpt", "selective"}) {
    EXPECT_FALSE(has(concerns_of(ball_behind("glass", "0.01"), integrator), through)) << integrator;
  }
  const char* on_others = "what they throw on other things is found by chance";
  EXPECT_TRUE(has(concerns_of(ball_behind("glass", "0.01"), "pt"), on_others));
  EXPECT_FALSE(has(concerns_of(ball_behind("glass", "1"), "pt"), on_others));
  EXPECT_FALSE(has(concerns_of(ball_behind("glass", "0.01"), "bdpt"), on_others));
}

TEST(Concerns, AreOfOrdinaryMonteCarloBesideChainsAsWell) {
  EXPECT_EQ(concerns_of(glass_and_metal(), "masked", {{"omc", "lt"}}).size(), 1U);
  EXPECT_TRUE(concerns_of(glass_and_metal(), "selective").empty());
}

TEST(Concerns, AreEmptyWhereOtherTechniquesSamplePaths) {
  for (const char* integrator : {"pt", "ibpt", "bdpt"}) {
    EXPECT_TRUE(concerns_of(glass_and_metal(), integrator).empty()) << integrator;
  }
  for (const char* techniques : {"light,implicit", "light,explicit", "light,inner"}) {
    EXPECT_TRUE(concerns_of(glass_and_metal(), "bdpt", {{"techniques", techniques}}).empty())
        << techniques;
  }
  EXPECT_EQ(concerns_of(glass_and_metal(), "bdpt", {{"techniques", "light"}}).size(), 1U);
}

TEST(Notes, NamePathsOutOfReachOfPathChains) {
  const auto scene = test::scene_from(glass_and_metal());
  test::RenderOptions options;
  options.integrator = "mlt";
  options.samples = 2;
  const auto say = [&](std::map<std::string, std::string> parameters) {
    options.parameters = std::move(parameters);
    std::string all;
    for (const std::string& note : test::render(*scene, options).integrator->findings().notes) {
      all += note + "\n";
    }
    return all.find("without bidirectional mutations") != std::string::npos;
  };
  EXPECT_FALSE(say({{"bootstrap", "2000"}}));
  EXPECT_TRUE(say({{"bootstrap", "2000"}, {"bidirectional", "0"}}));
}

TEST(Concerns, NameDepthsThatNoTechniqueMakes) {
  const std::string room = test::small_scene("Room").text;
  const auto of = [&](const char* integrator, const char* name, const char* techniques) {
    const auto concerns = concerns_of(room, integrator, {{name, techniques}});
    return concerns.empty() ? std::string() : concerns.front().message;
  };
  EXPECT_NE(of("bdpt", "techniques", "(2,2)").find("paths of 2, 4, 5"), std::string::npos);
  EXPECT_NE(of("bdpt", "techniques", "inner").find("paths of 2 edges"), std::string::npos);
  EXPECT_NE(of("selective", "techniques", "(2,2)").find("paths of 2, 4, 5"), std::string::npos);
  EXPECT_EQ(of("bdpt", "techniques", "explicit"), "");
}

TEST(Concerns, AreNoneAboutLampsThatScatterNothing) {
  EXPECT_TRUE(
      concerns_of(test::pbrt_scene("LookAt 0 0 -3  0 0 0  0 1 0 Camera \"perspective\"", 16, 16,
                                   "AreaLightSource \"diffuse\" Material \"matte\" \"rgb "
                                   "Kd\" [0 0 0] Shape \"sphere\""),
                  "lt")
          .empty());
}

}  // namespace
}  // namespace ajar
