// A filter of the user's own, and its interaction with other options.
#include <gtest/gtest.h>

#include <fstream>

#include "cli/cli_fixture.h"

namespace ajar {
namespace {

TEST_F(Cli, FilterOfTheUserReplacesThatOfTheScene) {
  const auto scene_with = [&](const std::string& filter) {
    std::ofstream(folder_ / (filter + ".pbrt"))
        << "LookAt 0 0 -3  0 0 0  0 1 0\nCamera \"perspective\"\nPixelFilter \"" << filter
        << "\"\nFilm \"image\" \"integer xresolution\" [16] \"integer yresolution\" [12]\n"
           "WorldBegin\nLightSource \"infinite\"\nShape \"sphere\"\nWorldEnd\n";
    return filter + ".pbrt";
  };
  const std::string sinc = scene_with("sinc");
  const auto picture_of = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"render", "--spp", "8",       "--integrator", "pt",
                                       "-o",     "a.pfm", "--stats", "stats.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return read_text(folder_ / "a.pfm");
  };
  const std::string of_scene = picture_of({sinc});
  EXPECT_TRUE(statistics().at("filter").is_null());
  const std::string box = picture_of({sinc, "--filter", "box"});
  EXPECT_EQ(statistics().at("filter"), "box");
  EXPECT_NE(box, of_scene);
  EXPECT_EQ(box, picture_of({scene_with("box")}));
}

TEST_F(Cli, FilterStaysWithTheCheckpoint) {
  ASSERT_EQ(render({"--spp", "16", "-o", "alone.pfm", "--filter", "mitchell:1.5"}).exit_code, 0);
  ASSERT_EQ(render({"--spp", "8", "-o", "a.pfm", "--checkpoint", "c", "--filter", "mitchell:1.5"})
                .exit_code,
            0);
  ASSERT_EQ(run({"resume", "c", "--spp", "16", "--progress", "none"}).exit_code, 0);
  EXPECT_EQ(read_text(folder_ / "a.pfm"), read_text(folder_ / "alone.pfm"));
  const Outcome other = render({"--spp", "16", "-o", "b.pfm", "--resume", "c", "--filter", "box"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_TRUE(contains(other.err, "filter mitchell:1.5, not filter box")) << other.err;
}

TEST_F(Cli, InvalidFilterIsRefused) {
  const Outcome outcome = render({"--filter", "gausian"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.err, "did you mean \"gaussian\"")) << outcome.err;
}

}  // namespace
}  // namespace ajar
