#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli_fixture.h"
#include "imageio/image_file.h"

/// Pictures without noise, as users get them.
namespace ajar::cli {
namespace {

class DenoiseCli : public Cli {
 protected:
  /// Renders 32×24 pixels, with these arguments beside.
  Outcome cornell(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {"render", "builtin:cornell", "--resolution",
                                          "32x24",  "--progress",      "none"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    if (std::find(more.begin(), more.end(), "--spp") == more.end()) {
      arguments.insert(arguments.end(), {"--spp", "8"});
    }
    return run(arguments);
  }
  Image image(const std::string& name) const { return read_image(file(name).string()); }
};

TEST_F(DenoiseCli, FiltersTheDisplayedPictureAndKeepsTheRawOne) {
  ASSERT_EQ(cornell({"-o", "a.exr", "-o", "a.png", "--stats", "a.json"}).exit_code, 0);
  ASSERT_EQ(cornell({"--denoise", "none", "-o", "b.exr", "-o", "b.png"}).exit_code, 0);
  const Image a = image("a.exr");
  const Image b = image("b.exr");
  EXPECT_EQ(a.rgb(), b.rgb()) << "the unfiltered picture does not hang on the filter";
  for (const char* layer : {"denoised", "denoised-error", "denoising-albedo", "denoising-normal"}) {
    EXPECT_FALSE(a.rgb(layer).empty()) << layer;
    EXPECT_TRUE(b.rgb(layer).empty()) << layer;
  }
  EXPECT_NE(image("a.png").rgb(), image("b.png").rgb());
  const json said = statistics("a.json");
  EXPECT_EQ(said.at("denoiser"), a.metadata.at("denoiser"));
  EXPECT_GT(said.at("estimated_denoised_error"), 0.0);
  EXPECT_LT(said.at("estimated_denoised_error"), 1.0);
  EXPECT_GT(said.at("seconds").at("denoise"), 0.0);
}

TEST_F(DenoiseCli, RendersUntilTheDenoisedPictureIsGood) {
  const Outcome outcome = cornell({"--denoise", "builtin", "--spp", "100000", "--target-error",
                                   "denoised:15%", "--stats", "a.json", "-o", "a.exr"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json said = statistics("a.json");
  EXPECT_EQ(said.at("stopped_by"), "target error");
  EXPECT_TRUE(said.at("budget").at("target_is_denoised"));
  EXPECT_LE(said.at("estimated_denoised_error"), 0.15);
  const json by_scale = said.at("estimated_error_by_scale");
  EXPECT_LT(by_scale.at("4").get<double>(), by_scale.at("1").get<double>());
  const Outcome unfiltered = cornell({"--denoise", "none", "--target-error", "denoised:5%"});
  EXPECT_EQ(unfiltered.exit_code, 2);
  EXPECT_TRUE(contains(unfiltered.err, "needs a filter")) << unfiltered.err;
}

/// Errors of the unfiltered picture, which a checkpoint keeps, say nothing of the filtered one.
TEST_F(DenoiseCli, ChecksAgainForAnotherTargetError) {
  ASSERT_EQ(cornell({"--integrator", "pt", "--denoise", "builtin", "--spp", "100000",
                     "--target-error", "30%", "--checkpoint", "a.checkpoint", "-o", "a.exr"})
                .exit_code,
            0);
  const Outcome outcome = run({"resume", "a.checkpoint", "--target-error", "denoised:20%",
                               "--stats", "b.json", "-o", "b.exr"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(statistics("b.json").at("stopped_by"), "target error");
  EXPECT_LE(statistics("b.json").at("estimated_denoised_error"), 0.2);
}

TEST_F(DenoiseCli, FiltersPicturesOfEarlierRenders) {
  ASSERT_EQ(
      render({"--denoise", "none", "--aov", "albedo,normal,replicates", "-o", "a.exr"}).exit_code,
      0);
  const Outcome outcome = run({"denoise", "a.exr", "-o", "b.exr", "-o", "b.png"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err.find("does not know"), std::string::npos) << outcome.err;
  const Image a = image("a.exr");
  const Image b = image("b.exr");
  EXPECT_EQ(a.rgb(), b.rgb());
  EXPECT_EQ(a.rgb("replicates.3"), b.rgb("replicates.3"));
  EXPECT_FALSE(b.rgb("denoised").empty());
  EXPECT_FALSE(b.rgb("denoised-error").empty());
  // Once more: from the current content of the file.
  ASSERT_EQ(run({"denoise", "b.exr", "-o", "c.exr"}).exit_code, 0);
  EXPECT_EQ(image("c.exr").rgb("denoised"), b.rgb("denoised"));
}

TEST_F(DenoiseCli, ReportsUnknownNames) {
  ASSERT_EQ(cornell({"--denoise", "none", "-o", "a.exr"}).exit_code, 0);
  const Outcome outcome = run({"denoise", "a.exr", "-o", "b.png"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.err.find("does not know the surfaces"), std::string::npos) << outcome.err;
}

TEST_F(DenoiseCli, RefusesContradictoryOptions) {
  ASSERT_EQ(cornell({"-o", "a.exr", "-o", "a.png"}).exit_code, 0);
  struct Case {
    std::vector<std::string> arguments;
    int exit_code;
    const char* text;
  };
  for (const Case& wrong :
       {Case{{"denoise", "a.exr"}, 2, "--output"},
        Case{{"denoise", "a.png", "-o", "b.png"}, 4, "display values"},
        Case{{"denoise", "no.exr", "-o", "b.png"}, 4, "no.exr"},
        Case{{"denoise", "a.exr", "-o", "a.exr"}, 2, "a.exr"},
        Case{{"denoise", "a.exr", "-o", "b.png", "--denoise", "none"}, 2, "none"},
        Case{{"denoise", "a.exr", "-o", "b.png", "--denoise", "oidm"}, 2, "oidn"},
        Case{{"render", "builtin:cornell", "--denoise", "outo"}, 2, "auto"}}) {
    const Outcome outcome = run(wrong.arguments);
    EXPECT_EQ(outcome.exit_code, wrong.exit_code) << wrong.text << ": " << outcome.err;
    EXPECT_NE(outcome.err.find(wrong.text), std::string::npos) << outcome.err;
  }
}

TEST_F(DenoiseCli, AsksForMemoryBeforeItIsTaken) {
  Picture picture;
  picture.resolution = {2000, 2000};
  picture.crop = Box2i(Vec2i(0, 0), Vec2i(1999, 1999));
  picture.layers.push_back({"", 3, std::vector<float>(std::size_t{3} * 2000 * 2000, 1.F)});
  write_image(file("large.exr").string(), picture);
  const auto denoised = [&](const char* how) {
    return finish(
        start({"denoise", "large.exr", "-o", "b.exr", "--denoise", how}, AJAR_PROGRAM, [] {
          constexpr rlim_t kLimit = 850'000'000;
          const rlimit limit{kLimit, kLimit};
          ::setrlimit(RLIMIT_AS, &limit);
        }));
  };
  for (const char* how : {"auto", "builtin"}) {
    const Outcome outcome = denoised(how);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "to denoise 2000x2000 pixels by ")) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, " are free here")) << outcome.err;
  }
}

TEST_F(DenoiseCli, SurvivesResumingAndMerging) {
  for (const char* seed : {"1", "2"}) {
    ASSERT_EQ(cornell({"--seed", seed, "--checkpoint", std::string(seed) + ".checkpoint", "-o",
                       std::string(seed) + ".exr"})
                  .exit_code,
              0);
  }
  ASSERT_EQ(run({"resume", "1.checkpoint", "--spp", "16", "--progress", "none"}).exit_code, 0);
  ASSERT_EQ(cornell({"--seed", "1", "--spp", "16", "-o", "whole.exr"}).exit_code, 0);
  const Image resumed = image("1.exr");
  const Image whole = image("whole.exr");
  EXPECT_EQ(resumed.rgb(), whole.rgb());
  EXPECT_EQ(resumed.rgb("denoised"), whole.rgb("denoised"));
  ASSERT_EQ(run({"merge", "1.checkpoint", "2.checkpoint", "-o", "merged.exr"}).exit_code, 0);
  EXPECT_FALSE(image("merged.exr").rgb("denoised").empty());
}

}  // namespace
}  // namespace ajar::cli
