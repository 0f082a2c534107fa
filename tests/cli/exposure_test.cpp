// Pictures for the eye as a user exposes them.
#include <gtest/gtest.h>

#include "cli/cli_fixture.h"
#include "imageio/image_file.h"

namespace ajar {
namespace {

class ExposureCli : public Cli {
 protected:
  Outcome render_to(const std::string& output, std::vector<std::string> more) const {
    more.insert(more.end(), {"--spp", "4", "-o", output});
    return render(more);
  }
  std::vector<float> pixels(const std::string& name) const {
    return read_image(file(name).string()).data;
  }
};

TEST_F(ExposureCli, AWhitePictureIsAWarningWithARemedy) {
  const Outcome white = render_to("a.png", {"--exposure", "8", "--checkpoint", "c"});
  EXPECT_TRUE(contains(white.err, " % of the picture is white: try --exposure ")) << white.err;
  const Outcome merged = run({"merge", "c", "--exposure", "8", "-o", "b.jpg"});
  EXPECT_TRUE(contains(merged.err, "is white: try --exposure ")) << merged.err;
  const Outcome black = render_to("a.png", {"--exposure", "-12"});
  EXPECT_TRUE(contains(black.err, " % of the picture is black: try --exposure ")) << black.err;
  for (const Outcome& fine : {render_to("a.exr", {"--exposure", "8"}), render_to("a.png", {}),
                              run({"merge", "c", "--exposure", "8", "-o", "b.exr"})}) {
    EXPECT_EQ(fine.exit_code, 0);
    EXPECT_FALSE(contains(fine.err, "try --exposure")) << fine.err;
  }
}

TEST_F(ExposureCli, AutoIsReportedStoredAndEqualToTheNumber) {
  const Outcome automatic =
      render_to("a.png", {"--exposure", "auto", "--stats", "stats.json", "--checkpoint", "c"});
  ASSERT_EQ(automatic.exit_code, 0) << automatic.err;
  const json exposure = statistics().at("exposure");
  EXPECT_EQ(exposure.at("auto"), true);
  ASSERT_GT(exposure.at("stops"), 0.0);
  const std::string stops = exposure.at("stops").dump();
  // 1.0 is +1 there.
  const std::string said = "exposure +" + stops.substr(0, stops.find(".0")) + " chosen";
  EXPECT_TRUE(contains(automatic.err, said)) << automatic.err;
  const std::vector<float> picture = pixels("a.png");
  ASSERT_EQ(render_to("b.png", {"--exposure", stops, "--stats", "b.json"}).exit_code, 0);
  EXPECT_EQ(statistics("b.json").at("exposure"),
            (json{{"stops", exposure.at("stops")}, {"auto", false}}));
  EXPECT_TRUE(pixels("b.png") == picture);
  // Exposure of before where nothing else is said.
  fs::remove(file("a.png"));
  EXPECT_TRUE(contains(run({"resume", "c"}).err, said));
  EXPECT_TRUE(pixels("a.png") == picture);
  EXPECT_FALSE(contains(run({"resume", "c", "--exposure", "0"}).err, "chosen"));
  EXPECT_TRUE(contains(
      run({"merge", "c", "--exposure", "auto", "--stats", "m.json", "-o", "m.png"}).err, said));
  EXPECT_TRUE(pixels("m.png") == picture);
  EXPECT_EQ(statistics("m.json").at("exposure"), exposure);
}

}  // namespace
}  // namespace ajar
