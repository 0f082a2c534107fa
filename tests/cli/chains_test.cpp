// Output on Markov chains: warnings, statistics, layers, options.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/cli_fixture.h"
#include "imageio/image_file.h"

namespace ajar {
namespace {

constexpr const char* kWalledLamp =
    "LookAt 0 0 -5  0 0 0  0 1 0\nCamera \"perspective\"\nWorldBegin\n"
    "Shape \"sphere\" \"float radius\" [1]\n"
    "AreaLightSource \"diffuse\" \"rgb L\" [5 5 5]\n"
    "Shape \"sphere\" \"float radius\" [0.3]\nWorldEnd\n";

int count_of(const std::string& text, const std::string& part) {
  int count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST_F(Cli, EveryMethodReportsABlackPicture) {
  file("walled.pbrt", kWalledLamp);
  file("unlit.pbrt", "Camera \"perspective\" WorldBegin Shape \"sphere\" WorldEnd");
  for (const std::string& method : integrators()) {
    for (const char* scene : {"walled.pbrt", "unlit.pbrt"}) {
      const Outcome outcome = run({"render", scene, "--integrator", method, "--resolution", "8x8",
                                   "--spp", "8", "--stats", "stats.json", "-o", "a.pfm"});
      ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
      EXPECT_EQ(count_of(outcome.err, "picture is black"), 1) << method << outcome.err;
      EXPECT_TRUE(contains(outcome.err, ", error unknown")) << method << outcome.err;
      EXPECT_TRUE(statistics().at("estimated_relative_error").is_null()) << method;
    }
  }
}

TEST_F(Cli, ChainsWithoutLightWarnAndRenderBlack) {
  const fs::path scene = file("dark.pbrt", kWalledLamp);
  for (const char* integrator : {"mmlt", "pssmlt", "mlt", "erpt"}) {
    const Outcome outcome =
        run({"render", scene.string(), "--integrator", integrator, "--resolution", "8x8", "--spp",
             "8", "--set", "bootstrap=2000", "--stats", "stats.json", "-o", "a.pfm"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "no light was found for Markov chains")) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "--set bootstrap=")) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "the picture is black")) << outcome.err;
    const json stats = statistics();
    EXPECT_EQ(stats.at("warnings"), 2);
    EXPECT_EQ(stats.at("chains"), 0);
    for (const json& depth : stats.at("b")) EXPECT_EQ(depth.at("b"), 0.0);
    for (const float value : read_image(file("a.pfm").string()).rgb()) EXPECT_EQ(value, 0.F);
  }
}

TEST_F(Cli, StatisticsTellWhatChainsDid) {
  const Outcome outcome = render({"--integrator", "mmlt", "--spp", "32", "--depth", "3:6", "--set",
                                  "bootstrap=20000", "--stats", "stats.json", "-o", "a.pfm"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json chains = statistics();
  EXPECT_GE(chains.at("mutations").get<int>(), 32 * 24 * 16);
  EXPECT_GT(chains.at("mutations_per_second").get<double>(), 0.0);
  EXPECT_GT(chains.at("chains").get<int>(), 0);
  EXPECT_GE(chains.at("bootstrap_samples").get<int>(), 19000);
  const json& acceptance = chains.at("acceptance");
  EXPECT_GT(acceptance.at("small").get<double>(), acceptance.at("large").get<double>());
  EXPECT_LE(acceptance.at("small").get<double>(), 1.0);
  ASSERT_EQ(acceptance.at("by_depth").size(), 4U);  // 3 to 6 edges
  ASSERT_EQ(chains.at("b").size(), 4U);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(chains.at("b").at(i).at("depth"), i + 3);
    const double b = chains.at("b").at(i).at("b");
    EXPECT_GT(b, 0.0);
    EXPECT_GT(chains.at("b").at(i).at("standard_error").get<double>(), 0.0);
    EXPECT_LT(chains.at("b").at(i).at("standard_error").get<double>(), 0.2 * b);
    EXPECT_EQ(acceptance.at("by_depth").at(i).at("depth"), i + 3);
  }
  EXPECT_GT(acceptance.at("by_technique").size(), 8U);
  for (const json& technique : acceptance.at("by_technique")) {
    EXPECT_GT(technique.at("proposals").get<int>(), 0);
    EXPECT_LE(technique.at("acceptance").get<double>(), 1.0);
  }
}

TEST_F(Cli, LayersOfChainsAreWritten) {
  const Outcome outcome =
      render({"--integrator", "pssmlt", "--spp", "32", "--set", "bootstrap=20000", "--set",
              "chains=100", "--aov", "density,acceptance", "-o", "a.exr", "-o", "b.png"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  // In false colours, with a legend.
  const Image map = read_image(file("b.density.png").string());
  EXPECT_GT(map.width, 24);
  EXPECT_GE(map.height, 16);
  const Image image = read_image(file("a.exr").string());
  double visits = 0.0;
  for (const float value : image.rgb("density")) visits += value;
  EXPECT_NEAR(visits / (3.0 * 24 * 16), 1.0, 0.1);
  const std::vector<float> acceptance = image.rgb("acceptance");
  ASSERT_FALSE(acceptance.empty());
  for (const float value : acceptance) {
    EXPECT_GE(value, 0.F);
    EXPECT_LE(value, 1.F);
  }
}

TEST_F(Cli, UnusableOptionsOfChainsAreWrongUsage) {
  struct Case {
    std::vector<std::string> settings;
    const char* message;
  };
  std::ofstream(folder_ / "black.pfm", std::ios::binary) << "PF\n24 16\n-1.0\n"
                                                         << std::string(24 * 16 * 12, '\0');
  const std::vector<Case> cases{
      {{"camera-steps=0.7", "light-steps=0.7"}, "together at most 1"},
      {{"techniques=explicit*3"}, "leave out counts"},
      {{"bootstrap=10"}, "bootstrap"},
      {{"mutation=gausian"}, "gaussian"},
      {{"rule=exakt"}, "exact"},
  };
  for (const Case& c : cases) {
    std::vector<std::string> arguments{"--integrator", "mmlt", "--spp", "1", "-o", "a.pfm"};
    for (const std::string& setting : c.settings) {
      arguments.insert(arguments.end(), {"--set", setting});
    }
    const Outcome outcome = render(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << c.message << ": " << outcome.err;
    EXPECT_TRUE(contains(outcome.err, c.message)) << outcome.err;
  }
  const Outcome black = render({"--spp", "1", "--set", "importance=black.pfm", "-o", "a.pfm"});
  EXPECT_EQ(black.exit_code, 2);
  EXPECT_TRUE(contains(black.err, "is black everywhere")) << black.err;
  // A map of another size than the picture's.
  const Outcome outcome = run({"render", "builtin:cornell", "--resolution", "20x16", "--spp", "1",
                               "--set", "importance=black.pfm", "-o", "a.pfm"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.err, "24x16")) << outcome.err;
}

}  // namespace
}  // namespace ajar
