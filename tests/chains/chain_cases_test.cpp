#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "core/error.h"
#include "integrator/integrator.h"
#include "mcmc/moments.h"
#include "session/output/output.h"
#include "support/mean_over_seeds.h"
#include "support/render.h"
#include "support/same_picture.h"
#include "support/small_scenes.h"

/// Chains where there is little light for them, and their reports.
namespace ajar {
namespace {

using test::expect_same;
using test::pbrt_scene;
using test::replicates_of;
using test::scene_from;

constexpr const char* kNumberChains[] = {"mmlt", "pssmlt"};
constexpr const char* kPathChains[] = {"mlt", "erpt"};
const std::string kCamera =
    "LookAt 0 1 -4  0 0.8 0  0 1 0\nCamera \"perspective\" \"float fov\" [45]";
const std::string kFloor =
    "Material \"matte\" \"rgb Kd\" [0.7 0.6 0.5]\n"
    "Shape \"trianglemesh\" \"point P\" [-2 0 -2  2 0 -2  2 0 2  -2 0 2] \"integer indices\" [0 2 "
    "1 0 3 2]\n"
    "Shape \"trianglemesh\" \"point P\" [-2 0 2  2 0 2  2 4 2  -2 4 2] \"integer indices\" [0 2 1 "
    "0 3 2]\n";

test::RenderOptions options_of(const std::string& integrator) {
  test::RenderOptions options;
  options.integrator = integrator;
  options.samples = 32;
  options.max_depth = 8;
  options.parameters = {{"bootstrap", "4000"}};
  return options;
}

double brightest(const std::vector<float>& pixels) {
  return *std::max_element(pixels.begin(), pixels.end());
}

struct DarkCase {
  const char* name;
  std::string world;
  friend void PrintTo(const DarkCase& c, std::ostream* out) { *out << c.name; }
};
class Dark : public ::testing::TestWithParam<DarkCase> {};

TEST_P(Dark, IsBlackWithAWarning) {
  const auto scene = scene_from(pbrt_scene(kCamera, 12, 8, GetParam().world), true);
  for (const char* integrator :
       {kNumberChains[0], kNumberChains[1], kPathChains[0], kPathChains[1]}) {
    test::RenderOptions options = options_of(integrator);
    options.min_depth = 3;  // indirect light
    const test::Render render = test::render(*scene, options);
    EXPECT_EQ(brightest(render.layer("indirect")), 0.0) << integrator;
    const std::vector<Warning> concerns = render.integrator->findings().concerns;
    ASSERT_EQ(concerns.size(), 1U) << integrator;
    EXPECT_NE(concerns[0].message.find("no light was found for Markov chains"), std::string::npos)
        << concerns[0].message;
    const MethodReport report = render.integrator->report();
    for (const auto& depth : report.at("b")) EXPECT_EQ(depth.at("b"), 0.0);
    EXPECT_EQ(report.at("chains"), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Dark,
    ::testing::Values(
        DarkCase{"Empty", ""}, DarkCase{"NoLights", kFloor},
        // One bounce off the sky is all there can be without surfaces.
        DarkCase{"SkyAlone", "LightSource \"infinite\" \"rgb L\" [1 1 1]\n"},
        DarkCase{"LightInABox",
                 kFloor + "AttributeBegin Material \"matte\" Translate 0 1 0\n"
                          "Shape \"sphere\" \"float radius\" [0.3]\n"
                          "AreaLightSource \"diffuse\" \"rgb L\" [9 9 9] Shape \"sphere\" \"float "
                          "radius\" [0.1] AttributeEnd\n"},
        DarkCase{"BlackSurfaces",
                 "LightSource \"point\" \"point from\" [1 1.5 -1]\nMaterial \"matte\" \"rgb Kd\" "
                 "[0 0 0]\nShape \"sphere\" \"float radius\" [1]\n"}),
    [](const auto& test) { return test.param.name; });

struct LitCase {
  const char* name;
  std::string world;
  int min_depth = 1;
  int max_depth = 8;
  int samples = 512;
  double power = 0.2;  ///< five errors of the mean, relative
  friend void PrintTo(const LitCase& c, std::ostream* out) { *out << c.name; }
};
class Lit : public ::testing::TestWithParam<LitCase> {};

TEST_P(Lit, HasTheBrightnessOfMonteCarlo) {
  const LitCase& lit = GetParam();
  const auto scene = scene_from(pbrt_scene(kCamera, 16, 16, lit.world));
  test::RenderOptions options;
  options.min_depth = lit.min_depth;
  options.max_depth = lit.max_depth;
  options.replicates = 16;
  options.samples = lit.samples;
  options.integrator = "bdpt";
  const Replicates truth = replicates_of(test::render(*scene, options), "indirect");
  options.parameters = {{"bootstrap", "30000"}};
  options.seed = 2;
  options.min_depth = std::max(3, lit.min_depth);
  for (const char* integrator : kNumberChains) {
    options.integrator = integrator;
    const test::Render render = test::render(*scene, options);
    expect_same(replicates_of(render, "indirect"), truth, *render.film, lit.power, integrator);
    EXPECT_TRUE(render.integrator->findings().concerns.empty()) << integrator;
  }
  options.samples = lit.samples / 4;
  for (const char* integrator : kPathChains) {
    options.integrator = integrator;
    const test::Render render = test::render(*scene, options);
    expect_same(replicates_of(render, "indirect"), truth, *render.film, 3.0 * lit.power,
                integrator);
    EXPECT_TRUE(render.integrator->findings().concerns.empty()) << integrator;
  }
}

const std::string kPoints =
    "LightSource \"point\" \"point from\" [1 1.5 -1]\nLightSource \"point\" \"point from\" [-1 0.5 "
    "0] \"rgb I\" [0.3 0.1 0.6]\n";
const std::string kTinyLight =
    "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [900 800 700] Translate 0 1.5 0\n"
    "Shape \"sphere\" \"float radius\" [0.02] AttributeEnd\n";

INSTANTIATE_TEST_SUITE_P(
    Scenes, Lit,
    ::testing::Values(
        LitCase{"PointLightsOnly", kPoints + kFloor},
        LitCase{"EnvironmentOnly", "LightSource \"infinite\" \"rgb L\" [1 1.2 1.5]\n" + kFloor},
        // Nothing but mirrors around the camera and the lamp.
        LitCase{"MirrorBox",
                "AttributeBegin Material \"mirror\" \"rgb Kr\" [0.6 0.6 0.6] ReverseOrientation\n"
                "Shape \"sphere\" \"float radius\" [6] AttributeEnd\n"
                "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [9 8 7] Translate 0 1 2\n"
                "Shape \"sphere\" \"float radius\" [1] AttributeEnd\n"},
        LitCase{"TinyLightBehindGlass",
                kFloor + kTinyLight +
                    "AttributeBegin Material \"glass\" Translate 0 1.5 0\n"
                    "Shape \"sphere\" \"float radius\" [0.2] AttributeEnd\n",
                1, 8, 512, 0.5},
        LitCase{"SixtyFourEdges",
                "AttributeBegin Material \"matte\" \"rgb Kd\" [0.9 0.9 0.9] ReverseOrientation\n"
                "Shape \"sphere\" \"float radius\" [6] AttributeEnd\n"
                "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [9 8 7] Translate 0 1 2\n"
                "Shape \"sphere\" \"float radius\" [1] AttributeEnd\n",
                1, 64, 64, 0.5},
        // The lamp lies in two panes of glass, each seen through twice: no light before k = 5.
        LitCase{"NothingBelowFiveEdges",
                "Material \"glass\" \"float index\" [1.2]\n"
                "AttributeBegin Translate 0 0.8 0 Shape \"sphere\" \"float radius\" [1.6] "
                "AttributeEnd\nAttributeBegin Translate 0 0.8 0 Material \"glass\" \"float index\" "
                "[1.1] Shape \"sphere\" \"float radius\" [1.2] AttributeEnd\n"
                "AttributeBegin Translate 0 0.8 0 Material \"mirror\" Shape \"sphere\" \"float "
                "radius\" [0.4] AttributeEnd\n"
                "LightSource \"infinite\" \"rgb L\" [1 1.2 1.5]\n",
                4, 5}),
    [](const auto& test) { return test.param.name; });

TEST(Depths, WithoutTechniquesOrLightAreLeftOutOrReportedAsDark) {
  // A ball of glass under a sky, seen from outside: without a surface that scatters, light comes
  // straight, by one reflection (2 edges), or through the ball (3, 4 with a reflection inside, …).
  const auto scene = scene_from(pbrt_scene(
      kCamera, 12, 8,
      "LightSource \"infinite\" \"rgb L\" [1 1 1]\nMaterial \"glass\"\nTranslate 0 0.8 0\n"
      "Shape \"sphere\" \"float radius\" [1]\n"));
  test::RenderOptions options = options_of("mmlt");
  options.min_depth = 3;
  // No next event estimation reaches the sky from glass.
  options.parameters["techniques"] = "(0,4),(1,5),(0,7)";
  const test::Render render = test::render(*scene, options);
  const MethodReport report = render.integrator->report();
  const MethodReport& b = report.at("b");
  ASSERT_EQ(b.size(), 3U);
  EXPECT_EQ(b[0].at("depth"), 3);
  EXPECT_GT(b[0].at("b"), 0.0);
  EXPECT_EQ(b[1].at("depth"), 5);
  EXPECT_EQ(b[1].at("b"), 0.0);
  EXPECT_EQ(report.at("acceptance").at("by_depth")[1].at("chains"), 0);
  EXPECT_EQ(b[2].at("depth"), 6);
  options.integrator = "pt";
  options.parameters = {{"techniques", "(0,4),(1,5),(0,7)"}};
  options.samples = 512;
  options.replicates = 16;
  const Replicates truth = replicates_of(test::render(*scene, options), "indirect");
  options.integrator = "mmlt";
  options.samples = 4096;
  options.parameters["bootstrap"] = "120000";
  const test::Render chains = test::render(*scene, options);
  expect_same(replicates_of(chains, "indirect"), truth, *chains.film, 0.1, "mmlt");
}

TEST(Sizes, FromASinglePixelOnKeepTheBrightness) {
  struct Size {
    Vec2i pixels;
    const char* chains;
    int samples;
  };
  for (const Size& size : {Size{{1, 1}, "100", 8192},
                           // More chains than mutations of a pass.
                           Size{{1, 1}, "400", 4096}, Size{{3, 2}, "100", 8192}}) {
    const auto scene =
        scene_from(pbrt_scene(kCamera, size.pixels.x, size.pixels.y, kPoints + kFloor));
    test::RenderOptions options;
    options.max_depth = 8;
    options.samples = 16384;
    options.replicates = 16;
    const Replicates truth = replicates_of(test::render(*scene, options), "indirect");
    options.seed = 2;
    options.min_depth = 3;
    options.samples = size.samples;
    options.parameters = {{"bootstrap", "30000"}, {"chains", size.chains}};
    for (const char* integrator : kNumberChains) {
      options.integrator = integrator;
      const test::Render render = test::render(*scene, options);
      expect_same(replicates_of(render, "indirect"), truth, *render.film, 0.4,
                  std::string(integrator) + ", chains " + size.chains);
    }
  }
}

TEST(Sizes, FromASinglePixelOnKeepTheBrightnessOfPaths) {
  for (const Vec2i& size : {Vec2i(1, 1), Vec2i(3, 2)}) {
    const auto scene = scene_from(pbrt_scene(kCamera, size.x, size.y, kPoints + kFloor));
    test::RenderOptions options;
    options.max_depth = 8;
    options.samples = 4096;
    options.replicates = 16;
    const Replicates truth = replicates_of(test::render(*scene, options));
    options.seed = 2;
    options.samples = 2048;
    options.parameters = {{"bootstrap", "16000"}};
    for (const char* integrator : kPathChains) {
      options.integrator = integrator;
      const test::Render render = test::render(*scene, options);
      expect_same(replicates_of(render), truth, *render.film, 0.35, integrator);
    }
  }
}

TEST(OneSample, OfOneReplicateIsRightOnAverage) {
  const auto scene = scene_from(pbrt_scene(kCamera, 3, 2, kPoints + kFloor));
  test::RenderOptions truth_options;
  truth_options.max_depth = 8;
  truth_options.samples = 16384;
  truth_options.replicates = 16;
  const Estimate truth = image_mean(replicates_of(test::render(*scene, truth_options), "indirect"));
  for (const char* integrator : kNumberChains) {
    for (const char* chains : {"64", "1000"}) {
      test::RenderOptions options = options_of(integrator);
      options.samples = 1;
      options.replicates = 1;
      options.min_depth = 3;
      options.parameters = {{"bootstrap", "1000"}, {"chains", chains}};
      const auto indirect = [&](std::uint64_t seed) {
        options.seed = seed;
        const std::vector<float> pixels = test::render(*scene, options).layer("indirect");
        return std::accumulate(pixels.begin(), pixels.end(), 0.0) /
               static_cast<double>(pixels.size());
      };
      test::expect_mean_over_seeds({truth.value, truth.standard_error, 0.2 * truth.value}, 200,
                                   indirect, std::string(integrator) + ", chains " + chains);
    }
  }
}

TEST(OneSample, OfPathsOfOneReplicateIsRightOnAverage) {
  const auto scene = scene_from(pbrt_scene(kCamera, 3, 2, kPoints + kFloor));
  test::RenderOptions truth_options;
  truth_options.max_depth = 8;
  truth_options.samples = 16384;
  truth_options.replicates = 16;
  const Estimate truth = image_mean(replicates_of(test::render(*scene, truth_options)));
  for (const char* integrator : kPathChains) {
    test::RenderOptions options = options_of(integrator);
    options.samples = 1;
    options.replicates = 1;
    options.parameters = {{"bootstrap", "1000"}};
    const auto mean = [&](std::uint64_t seed) {
      options.seed = seed;
      return test::render(*scene, options).mean();
    };
    test::expect_mean_over_seeds({truth.value, truth.standard_error, 0.4 * truth.value}, 200, mean,
                                 integrator);
  }
}

TEST(ChainLayers, DensityCountsVisitsAndAcceptanceIsAProbability) {
  const auto scene = scene_from(pbrt_scene(kCamera, 24, 16, kPoints + kFloor));
  for (const char* integrator : kNumberChains) {
    test::RenderOptions options = options_of(integrator);
    options.samples = 64;
    options.replicates = 4;
    options.aovs = {"density", "acceptance"};
    // Enough seeds for each replicate, and a mutation per pixel for each chain.
    options.parameters = {{"bootstrap", "100000"}, {"chains", "100"}};
    const test::Render render = test::render(*scene, options);
    const std::vector<float> density = render.layer("density");
    double sum = 0.0;
    for (const float value : density) {
      EXPECT_GE(value, 0.F);
      sum += value;
    }
    // Each of a pass's mutations brings one visit; rounding makes them a few more than wanted.
    EXPECT_NEAR(sum / static_cast<double>(density.size()), 1.0, 0.02) << integrator;
    const std::vector<float> acceptance = render.layer("acceptance");
    for (std::size_t i = 0; i < acceptance.size(); i += 3) {
      EXPECT_GE(acceptance[i], 0.F);
      EXPECT_LE(acceptance[i], acceptance[i + 1] * 1.00001F + 1e-6F);
    }
  }
}

TEST(ChainReports, HaveTheCostOfMoves) {
  const auto scene = scene_from(pbrt_scene(
      kCamera, 24, 16,
      kPoints + kFloor +
          "Material \"glass\"\nTranslate 0 0.8 0\nShape \"sphere\" \"float radius\" [0.4]\n"));
  test::RenderOptions options = options_of("mlt");
  options.max_depth = 6;
  options.parameters["bootstrap"] = "20000";
  const auto rays_of_moves = [](const MethodReport& report) {
    double rays = 0.0;
    for (const auto& move : report.at("acceptance").at("by_move")) {
      rays += move.at("rays").get<double>() * move.at("proposals").get<double>();
    }
    return rays;
  };
  options.samples = 32;
  const test::Render shorter = test::render(*scene, options);
  options.samples = 64;
  const test::Render longer = test::render(*scene, options);
  // The bootstrap is the same, so that the rays of the others are those of the moves.
  const auto more = static_cast<double>(longer.counters.rays - shorter.counters.rays);
  EXPECT_NEAR(
      rays_of_moves(longer.integrator->report()) - rays_of_moves(shorter.integrator->report()),
      more, 1e-9 * more);
  std::uint64_t proposals = 0;
  bool walked = false;
  const MethodReport report = longer.integrator->report();
  for (const auto& move : report.at("acceptance").at("by_move")) {
    const auto tries = move.at("proposals").get<std::uint64_t>();
    proposals += tries;
    EXPECT_GT(move.at("dark"), 0.0);
    EXPECT_LE(move.at("dark"), 1.0 - move.at("acceptance").get<double>());
    if (!move.contains("lost_walks")) continue;
    walked = true;
    EXPECT_EQ(move.at("move"), "manifold");
    const auto failed =
        move.at("lost_walks").get<std::uint64_t>() + move.at("one_way_walks").get<std::uint64_t>();
    EXPECT_LE(static_cast<double>(failed), move.at("dark").get<double>() * tries * (1.0 + 1e-9));
  }
  EXPECT_TRUE(walked);
  EXPECT_EQ(proposals, longer.counters.mutations);
}

std::set<std::string> tried_moves(const MethodReport& report) {
  std::set<std::string> names;
  for (const auto& move : report.at("acceptance").at("by_move")) {
    names.insert(move.at("move").get<std::string>());
  }
  return names;
}

/// A ball of glass that is seen, under lamps, on a floor: each mutation finds paths that are for
/// it.
TEST(MutationsOfPaths, AreNeverTriedWithAWeightOfZero) {
  const auto scene = scene_from(pbrt_scene(
      kCamera, 24, 16,
      kPoints + kFloor +
          "Material \"glass\"\nTranslate 0 0.8 0\nShape \"sphere\" \"float radius\" [0.4]\n"));
  for (const char* integrator : kPathChains) {
    test::RenderOptions options = options_of(integrator);
    options.max_depth = 6;
    options.samples = 8;
    options.parameters["bidirectional"] = "1";
    const std::set<std::string> all =
        tried_moves(test::render(*scene, options).integrator->report());
    for (const char* off : {"bidirectional", "lens-subpath", "lens", "caustic", "manifold"}) {
      EXPECT_TRUE(all.count(off) > 0) << integrator << ", " << off;
      test::RenderOptions without = options;
      without.parameters[off] = "0";
      const test::Render render = test::render(*scene, without);
      const std::set<std::string> tried = tried_moves(render.integrator->report());
      EXPECT_EQ(tried.count(off), 0U) << integrator << ", " << off;
      EXPECT_GE(tried.size(), 3U) << integrator << ", " << off;
    }
  }
}

/// Steps for which no mutation is are none of the first mutation.
TEST(MutationsOfPaths, UnsuitableOnesLeaveStepsIdle) {
  const auto scene = scene_from(pbrt_scene(kCamera, 12, 8, kPoints + kFloor));
  test::RenderOptions options = options_of("mlt");
  options.samples = 8;
  for (const char* off :
       {"bidirectional", "lens-subpath", "lens", "caustic", "multi-chain", "half-vector"}) {
    options.parameters[off] = "0";
  }
  const test::Render render = test::render(*scene, options);
  const MethodReport report = render.integrator->report();
  EXPECT_TRUE(tried_moves(report).empty()) << "without glass no path is for manifold alone";
  EXPECT_EQ(report.at("acceptance").at("idle"), render.counters.mutations);
  EXPECT_GT(render.mean(), 0.0);
}

TEST(MutationsOfPaths, AreRefusedIfAllAreSwitchedOff) {
  const auto scene = scene_from(pbrt_scene(kCamera, 4, 4, kPoints + kFloor));
  for (const char* integrator : kPathChains) {
    test::RenderOptions options = options_of(integrator);
    for (const char* off : {"bidirectional", "lens-subpath", "lens", "caustic", "multi-chain",
                            "manifold", "half-vector"}) {
      options.parameters[off] = "0";
    }
    try {
      test::render(*scene, options);
      ADD_FAILURE() << integrator;
    } catch (const UsageError& error) {
      EXPECT_EQ(
          std::string(error.what()),
          "all of bidirectional, lens-subpath, lens, caustic, multi-chain, manifold, half-vector "
          "are 0: chains need a mutation that is not");
    }
    options.parameters["caustic"] = "0.001";
    EXPECT_NO_THROW(test::render(*scene, options)) << integrator;
  }
}

TEST(ChainReports, HaveTheStatisticsOfChains) {
  const auto scene = scene_from(pbrt_scene(kCamera, 24, 16, kPoints + kFloor));
  test::RenderOptions options = options_of("mmlt");
  options.min_depth = 3;
  options.max_depth = 5;
  options.parameters["bootstrap"] = "40000";
  options.samples = 64;
  const test::Render render = test::render(*scene, options);
  const MethodReport report = render.integrator->report();
  const MethodReport& acceptance = report.at("acceptance");
  const MethodReport& by_depth = acceptance.at("by_depth");
  ASSERT_EQ(by_depth.size(), 3U);  // 3, 4 and 5 edges
  std::uint64_t mutations = 0;
  std::uint64_t proposals = 0;
  for (const auto& depth : by_depth) {
    mutations += depth.at("mutations").get<std::uint64_t>();
    EXPECT_GT(depth.at("chains"), 0);
    EXPECT_GT(depth.at("acceptance"), 0.0);
    EXPECT_LT(depth.at("acceptance"), 1.0);
  }
  for (const auto& depth : report.at("b")) {
    EXPECT_GT(depth.at("b"), 0.0);
    EXPECT_GT(depth.at("standard_error"), 0.0);
  }
  for (const auto& technique : acceptance.at("by_technique")) {
    proposals += technique.at("proposals").get<std::uint64_t>();
    EXPECT_GE(technique.at("acceptance"), 0.0);
    EXPECT_LE(technique.at("acceptance"), 1.0);
  }
  EXPECT_EQ(mutations, render.counters.mutations);
  EXPECT_EQ(proposals, mutations);
  EXPECT_GT(acceptance.at("small"), acceptance.at("large"));
  EXPECT_GE(static_cast<double>(mutations), 64.0 * 24 * 16);
}

TEST(ChainReports, EffortFollowsErrors) {
  // Hardly any light is above the division, so mutations beyond the first guess would be wasted.
  const auto scene = scene_from(pbrt_scene(kCamera, 72, 48, kPoints + kFloor));
  const auto mutations = [&](const char* split) {
    test::RenderOptions options;
    options.integrator = "selective";
    options.samples = 64;
    options.replicates = 4;
    options.max_depth = 8;
    options.parameters["split"] = split;
    return static_cast<double>(test::render(*scene, options).counters.mutations) / (72 * 48);
  };
  const double few = mutations("100");
  EXPECT_LT(few, 8.0);
  EXPECT_GT(mutations("0.3"), 3.0 * few);
}

TEST(ChainReports, GiveBAnErrorBarThatCoversIt) {
  const auto scene = scene_from(pbrt_scene(kCamera, 12, 8, kPoints + kFloor));
  for (const char* integrator : kNumberChains) {
    constexpr int kSeeds = 100;
    Moments b;
    double error_variance = 0.0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      test::RenderOptions options = options_of(integrator);
      options.samples = 1;  // b comes before them
      options.min_depth = 3;
      options.max_depth = 4;
      options.seed = seed;
      const MethodReport report = test::render(*scene, options).integrator->report();
      const MethodReport& first = report.at("b")[0];
      b.add(first.at("b").get<double>());
      error_variance += std::pow(first.at("standard_error").get<double>(), 2) / kSeeds;
    }
    // Five standard deviations of Fisher's z with 99 degrees of freedom on one side and very many
    // on the other: an error bar wrong by half is noticed.
    const double ratio = std::pow(b.standard_error(), 2) * kSeeds / error_variance;
    EXPECT_LT(std::abs(0.5 * std::log(ratio)), 5.0 * std::sqrt(0.5 / (kSeeds - 1)))
        << integrator << ": variance ratio " << ratio;
  }
}

TEST(ChainReports, GiveTheBOfPathsAnErrorBarThatCoversIt) {
  const auto scene = scene_from(pbrt_scene(kCamera, 12, 8, kPoints + kFloor));
  constexpr int kSeeds = 60;
  Moments b;
  double error_variance = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    test::RenderOptions options = options_of("mlt");
    options.max_depth = 4;
    options.samples = 2;
    options.seed = seed;
    options.parameters["bootstrap"] = "2000";
    const MethodReport report = test::render(*scene, options).integrator->report();
    const MethodReport& only = report.at("b")[0];
    b.add(only.at("b").get<double>());
    error_variance += std::pow(only.at("standard_error").get<double>(), 2) / kSeeds;
  }
  // Fisher's z again: an error bar wrong by a factor of 1.6 is noticed.
  const double ratio = std::pow(b.standard_error(), 2) * kSeeds / error_variance;
  EXPECT_LT(std::abs(0.5 * std::log(ratio)), 5.0 * std::sqrt(0.5 / (kSeeds - 1)))
      << "variance ratio " << ratio;
}

/// Each extension of mmlt makes other chains, and so does the mask of a part of the light.
TEST(ExtensionsOfMmlt, ChangeTheChains) {
  const auto scene = scene_from(pbrt_scene(kCamera, 16, 12, kPoints + kFloor));
  test::RenderOptions options = options_of("mmlt");
  options.replicates = 4;
  options.samples = 32;
  const std::vector<float> plain = test::render(*scene, options).image();
  using Settings = std::map<std::string, std::string>;
  for (const Settings& settings :
       {Settings{{"step", "adaptive"}, {"m1", "1"}, {"k1", "1"}, {"k2", "1"}},
        Settings{{"mutation", "slemmlt"}, {"w", "1"}}, Settings{{"multi-try", "2"}},
        Settings{{"camera-steps", "0.5"}}, Settings{{"seeds", "filtered"}, {"seed-spread", "0"}}}) {
    test::RenderOptions own = options;
    own.parameters.insert(settings.begin(), settings.end());
    EXPECT_NE(test::render(*scene, own).image(), plain) << settings.begin()->first;
  }
  // slemmlt moves numbers like gaussian until its map is there.
  options.parameters["mutation"] = "gaussian";
  const std::vector<float> gaussian = test::render(*scene, options).image();
  options.parameters.insert({{"w", "1"}});
  options.parameters["mutation"] = "slemmlt";
  EXPECT_NE(test::render(*scene, options).image(), gaussian);
}

TEST(Techniques, WithCountsAreRefusedByChains) {
  const auto scene = scene_from(pbrt_scene(kCamera, 4, 4, kPoints + kFloor));
  for (const char* integrator : kNumberChains) {
    for (const char* techniques : {"implicit,explicit*2", "pt,light*0.5", "bdpt,(2,2)*0.3"}) {
      test::RenderOptions options = options_of(integrator);
      options.parameters["techniques"] = techniques;
      EXPECT_THROW(test::render(*scene, options), UsageError) << integrator << ", " << techniques;
    }
  }
}

}  // namespace
}  // namespace ajar
