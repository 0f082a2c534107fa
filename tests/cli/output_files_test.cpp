#include "cli/cli_fixture.h"

namespace ajar {
namespace {

/// The program beside what somebody else has put into the folder it writes to.
class OutputFiles : public Cli {
 protected:
  void SetUp() override {
    Cli::SetUp();
    file("scene.pbrt",
         "Camera \"perspective\"\nWorldBegin\nLightSource \"point\"\nShape \"sphere\"\n"
         "Shape \"trianglemesh\" \"integer indices\" [0 1 2] \"point P\" [0 0 0 1 0 0 0 1 0]\n"
         "WorldEnd\n");
  }
};

TEST_F(OutputFiles, ConvertWritesThroughNoLinkAtATemporaryName) {
  file("victim", "untouched");
  // The shell becomes the program and keeps its number.
  const std::string script =
      "ln -s victim \"out.pbrt.tmp$$\"; exec " AJAR_PROGRAM " convert scene.pbrt out.pbrt";
  const Outcome outcome = finish(start({"-c", script}, "/bin/sh"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(read_text(file("victim")), "untouched");
  EXPECT_TRUE(contains(read_text(file("out.pbrt")), "WorldEnd"));
}

TEST_F(OutputFiles, ConvertKeepsLinksAndModes) {
  file("real.pbrt", "old");
  fs::permissions(file("real.pbrt"), fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("real.pbrt", file("out.pbrt"));
  const Outcome outcome = run({"convert", "scene.pbrt", "out.pbrt"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(fs::is_symlink(file("out.pbrt")));
  EXPECT_TRUE(contains(read_text(file("real.pbrt")), "WorldEnd"));
  EXPECT_EQ(fs::status(file("real.pbrt")).permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(OutputFiles, MayHaveTheLongestNames) {
  for (const std::size_t size : {242U, 255U}) {
    const std::string stem(size - 4, 'n');
    const Outcome outcome = render({"--spp", "1", "-o", stem + ".exr", "--stats", stem + ".jsn",
                                    "--checkpoint", stem + ".ckp"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const char* extension : {".exr", ".jsn", ".ckp"}) {
      EXPECT_TRUE(fs::exists(file(stem + extension))) << size << extension;
    }
  }
}

TEST_F(OutputFiles, LongerNamesAreRefusedBeforeRendering) {
  for (const char* option : {"-o", "--checkpoint", "--stats"}) {
    const Outcome outcome = render({"--spp", "100000000", option, std::string(252, 'n') + ".exr"});
    EXPECT_EQ(outcome.exit_code, 4) << option;
    EXPECT_TRUE(contains(outcome.err, "it has 256 bytes, of at most 255")) << outcome.err;
  }
}

}  // namespace
}  // namespace ajar
