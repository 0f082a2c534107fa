#include <sys/stat.h>

#include "cli/cli_fixture.h"

namespace ajar {
namespace {

/// The program beside files of others in the folder it writes to.
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

TEST_F(OutputFiles, NamedPipesAreRefusedAtOnce) {
  ASSERT_EQ(render({"--spp", "1", "-o", "a.exr", "--checkpoint", "a.checkpoint"}).exit_code, 0);
  for (const char* name : {"pipe", "pipe.exr", "pipe.png", "pipe.pbrt"}) {
    ASSERT_EQ(mkfifo(file(name).c_str(), 0600), 0);
  }
  fs::create_symlink("pipe.exr", file("link.exr"));
  const auto expect_refused = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"-s", "KILL", "60", AJAR_PROGRAM});
    const Outcome outcome = finish(start(arguments, "/usr/bin/timeout"));
    EXPECT_EQ(outcome.exit_code, 4) << arguments[4] << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "it is a named pipe")) << outcome.err;
  };
  const std::vector<std::string> endless = {"render", "builtin:cornell", "--spp", "100000000"};
  for (const std::vector<std::string>& more :
       std::vector<std::vector<std::string>>{{"-o", "pipe.exr"},
                                             {"-o", "link.exr"},
                                             {"-o", "b.exr", "-o", "pipe.png"},
                                             {"-o", "b.exr", "--checkpoint", "pipe"},
                                             {"-o", "b.exr", "--stats", "pipe"}}) {
    std::vector<std::string> arguments = endless;
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_refused(arguments);
  }
  expect_refused({"denoise", "a.exr", "-o", "pipe.png"});
  expect_refused({"merge", "a.checkpoint", "-o", "pipe.exr"});
  expect_refused({"merge", "a.checkpoint", "--checkpoint", "pipe"});
  expect_refused({"resume", "a.checkpoint", "-o", "pipe.exr"});
  expect_refused({"convert", "scene.pbrt", "pipe.pbrt"});
}

TEST_F(OutputFiles, PipesOfTheShellAreWritten) {
  const std::string script = AJAR_PROGRAM
      " render builtin:cornell --resolution 8x6 --spp 1 --progress none -o a.exr --stats "
      "/dev/stderr 2>&1 >/dev/null | cat > said";
  EXPECT_EQ(finish(start({"-c", script}, "/bin/sh")).exit_code, 0);
  EXPECT_TRUE(contains(read_text(file("said")), "\"integrator\"")) << read_text(file("said"));
}

TEST_F(OutputFiles, ConvertRefusesTheNamesThatRenderRefuses) {
  file(
      "flat.pbrt",
      "Scale 5e17 -9223372036854775809 1\nLookAt -0.3 0.5 -0.5  0 0.075 0  0 1 0\n"
      "Camera \"perspective\"\nWorldBegin\nLightSource \"infinite\"\nShape \"sphere\"\nWorldEnd\n");
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"convert", "flat.pbrt", "b.pbrt"}, {"render", "flat.pbrt", "-o", "b.exr"}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 3) << arguments[0] << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "flat.pbrt:3:1: the transform of the camera cannot"))
        << outcome.err;
  }
  EXPECT_FALSE(fs::exists(file("b.pbrt")));
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
