// Ways in which a render used to lose work, its own or that of others.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include "cli/cli_fixture.h"
#include "imageio/image_file.h"

namespace ajar {
namespace {

class LostWorkCli : public Cli {
 protected:
  std::string bytes(const std::string& name) const { return read_text(folder_ / name); }
  /// A scene of several files.
  void write_scene() const {
    file("scene.pbrt",
         "Film \"image\" \"integer xresolution\" 8 \"integer yresolution\" 8\nWorldBegin\n"
         "Include \"lights.pbrt\"\nShape \"plymesh\" \"string filename\" \"mesh.ply\"\n"
         "WorldEnd\n");
    file("lights.pbrt",
         "LightSource \"point\" \"point from\" [0 0 5]\n"
         "Texture \"wood\" \"color\" \"imagemap\" \"string filename\" \"wood.pfm\"\n"
         "Material \"matte\" \"texture Kd\" \"wood\"\n");
    file("mesh.ply",
         "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
         "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
         "-9 -9 3\n9 -9 3\n0 9 3\n3 0 1 2\n");
    Picture wood;
    wood.resolution = {2, 2};
    wood.crop = Box2i({0, 0}, {1, 1});
    wood.layers.push_back({"", 3, std::vector<float>(12, 0.5F)});
    write_image(file("wood.pfm").string(), wood);
  }
};

TEST_F(LostWorkCli, ANewRenderDoesNotReplaceACheckpoint) {
  ASSERT_EQ(render({"--spp", "8", "--checkpoint", "c"}).exit_code, 0);
  const std::string before = bytes("c");
  const Outcome again = render({"--spp", "4", "--checkpoint", "c"});
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_TRUE(contains(again.err, "ajar resume c")) << again.err;
  EXPECT_EQ(bytes("c"), before);
  EXPECT_EQ(render({"--spp", "16", "--checkpoint", "c", "--resume", "c"}).exit_code, 0);
  ASSERT_EQ(render({"--spp", "4", "--checkpoint", "d"}).exit_code, 0);
  EXPECT_EQ(run({"resume", "d", "--spp", "8", "--checkpoint", "c"}).exit_code, 2);
  // Empty files, as of mktemp, are no checkpoints yet.
  std::ofstream(file("e")).flush();
  EXPECT_EQ(render({"--spp", "4", "--checkpoint", "e"}).exit_code, 0);
}

TEST_F(LostWorkCli, InputsAreNotOverwritten) {
  write_scene();
  fs::create_symlink("scene.pbrt", folder_ / "link.png");
  fs::create_hard_link(folder_ / "wood.pfm", folder_ / "hard.pfm");
  ASSERT_EQ(run({"render", "scene.pbrt", "--spp", "1", "-o", "a.pfm"}).exit_code, 0);
  for (const std::vector<std::string>& files : {std::vector<std::string>{"--stats", "scene.pbrt"},
                                                {"--stats", "lights.pbrt"},
                                                {"--stats", "./mesh.ply"},
                                                {"-o", "wood.pfm"},
                                                {"-o", "hard.pfm"},
                                                {"-o", "link.png"}}) {
    const std::string read = bytes(files[1]);
    std::vector<std::string> arguments = {"render", "scene.pbrt", "--spp", "1"};
    arguments.insert(arguments.end(), files.begin(), files.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << files[1] << ": " << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "overwrite what is read")) << outcome.err;
    EXPECT_EQ(bytes(files[1]), read) << files[1];
  }
  EXPECT_EQ(run({"render", "scene.pbrt", "--checkpoint", "scene.pbrt"}).exit_code, 2);
  EXPECT_EQ(run({"convert", "scene.pbrt", "lights.pbrt"}).exit_code, 2);
  EXPECT_EQ(run({"convert", "scene.pbrt", "scene.pbrt"}).exit_code, 2);
}

TEST_F(LostWorkCli, AMergeKeepsItsParts) {
  ASSERT_EQ(render({"--seed", "1", "--checkpoint", "c1", "-o", "a.pfm"}).exit_code, 0);
  ASSERT_EQ(render({"--seed", "2", "--checkpoint", "c2", "-o", "a.pfm"}).exit_code, 0);
  const std::string before = bytes("c2");
  for (const std::string option : {"--stats", "--checkpoint"}) {
    const Outcome outcome = run({"merge", "c1", "c2", "-o", "m.pfm", option, "./c2"});
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_EQ(bytes("c2"), before);
  }
  EXPECT_EQ(run({"merge", "c1", "c2", "--checkpoint", "whole"}).exit_code, 0);
}

TEST_F(LostWorkCli, OneCheckpointIsOfOneRender) {
  const std::vector<std::string> endless = {
      "render", "builtin:cornell", "--resolution", "24x16", "--time", "1h", "--checkpoint",
      "c",      "--progress",      "json",         "-o",    "a.pfm"};
  const pid_t first = start(endless);
  ASSERT_TRUE(wait_for(folder_ / ".stderr", "\"progress\",\"phase\":\"render\""));
  std::vector<std::string> other = endless;
  other.insert(other.end(), {"--seed", "2"});
  const Outcome second = run(other);
  EXPECT_EQ(second.exit_code, 4);
  EXPECT_TRUE(contains(second.err, "another render keeps its checkpoint there")) << second.err;
  kill(first, SIGINT);
  EXPECT_EQ(finish(first).exit_code, 130);
  // After a hard end the lock is free.
  const pid_t third = start({"resume", "c", "--time", "1h", "--progress", "json"});
  ASSERT_TRUE(wait_for(folder_ / ".stderr", "\"progress\",\"phase\":\"render\""));
  EXPECT_EQ(run({"resume", "c"}).exit_code, 4);
  kill(third, SIGKILL);
  finish(third);
  EXPECT_EQ(run({"resume", "c", "--spp", "4"}).exit_code, 0);
}

/// A limit on the size of files is as good as full disks: of the target's folder, the current one
/// and the one for temporary files at once.
class FullDisksCli : public LostWorkCli {
 protected:
  /// Ends its render by a signal, and waits until it has found that there is no room.
  pid_t start_without_room() const {
    const pid_t child =
        start({"render", "builtin:cornell", "--resolution", "160x100", "--time", "1h", "--progress",
               "json", "--threads", "1", "-o", "a.pfm", "--checkpoint", "c"});
    EXPECT_TRUE(wait_for(folder_ / ".stderr", "\"progress\",\"phase\":\"render\""));
    limit(child, 20000);
    kill(child, SIGINT);
    EXPECT_TRUE(wait_for(folder_ / ".stderr", "waits until there is room"));
    return child;
  }
  static void limit(pid_t child, rlim_t bytes) {
    const rlimit size{bytes, RLIM_INFINITY};
    ASSERT_EQ(prlimit(child, RLIMIT_FSIZE, &size, nullptr), 0);
  }
};

TEST_F(FullDisksCli, ARenderWaitsForSpaceAndThenWritesAll) {
  const pid_t child = start_without_room();
  EXPECT_FALSE(fs::exists(folder_ / "a.pfm"));
  limit(child, RLIM_INFINITY);
  const Outcome outcome = finish(child);
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  EXPECT_EQ(read_image(file("a.pfm").string()).width, 160);
  EXPECT_EQ(run({"resume", "c", "--spp", "1", "-o", "b.pfm"}).exit_code, 0);
}

TEST_F(FullDisksCli, TheUserMayGiveUp) {
  const pid_t child = start_without_room();
  kill(child, SIGINT);
  const Outcome outcome = finish(child);
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_TRUE(contains(outcome.err, "the picture is lost")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "the checkpoint is lost")) << outcome.err;
}

}  // namespace
}  // namespace ajar
