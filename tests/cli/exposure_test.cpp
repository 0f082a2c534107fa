// Pictures for the eye as a user exposes them.
#include <gtest/gtest.h>

#include "cli/cli_fixture.h"

namespace ajar {
namespace {

class ExposureCli : public Cli {
 protected:
  Outcome render_to(const std::string& output, std::vector<std::string> more) const {
    more.insert(more.end(), {"--spp", "4", "-o", output});
    return render(more);
  }
};

TEST_F(ExposureCli, AWhitePictureIsToldAndWhatToTry) {
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

}  // namespace
}  // namespace ajar
