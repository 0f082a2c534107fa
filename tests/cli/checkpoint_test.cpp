// Checkpoints and resuming, from the command line.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <chrono>
#include <cstdlib>
#include <random>
#include <thread>
#include <tuple>

#include "cli/cli_fixture.h"
#include "imageio/image_file.h"
#include "session/testing/checksums.h"
#include "session/testing/fake_viewer.h"

namespace ajar {
namespace {

class CheckpointCli : public Cli {
 protected:
  std::string bytes(const std::string& name) const { return read_text(folder_ / name); }
  /// An endless render that has begun, with a checkpoint.
  pid_t start_endless(const std::vector<std::string>& more,
                      const std::string& resolution = "32x24") const {
    std::vector<std::string> arguments{
        "render", "builtin:cornell", "--resolution", resolution, "--time",
        "1h",     "--progress",      "json",         "--stats",  "stats.json",
        "-o",     "a.exr",           "--threads",    "1"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const pid_t child = start(arguments);
    EXPECT_TRUE(wait_for(folder_ / ".stderr", "\"progress\",\"phase\":\"render\""))
        << read_text(folder_ / ".stderr");
    return child;
  }
};

TEST_F(CheckpointCli, ResumedRenderHasTheBitsOfOneLeftAlone) {
  ASSERT_EQ(render({"--spp", "32", "-o", "alone.pfm"}).exit_code, 0);
  ASSERT_EQ(render({"--spp", "8", "-o", "a.pfm", "--checkpoint", "c"}).exit_code, 0);
  EXPECT_NE(bytes("a.pfm"), bytes("alone.pfm"));
  const Outcome extended =
      run({"resume", "c", "--spp", "16", "--progress", "none", "--stats", "stats.json"});
  ASSERT_EQ(extended.exit_code, 0) << extended.err;
  EXPECT_TRUE(contains(extended.out, "/a.pfm")) << "the same file as before";
  EXPECT_EQ(statistics().at("resumptions"), 1);
  EXPECT_EQ(statistics().at("resumed_from"), "c");
  EXPECT_EQ(statistics().at("samples_per_pixel"), 16);
  ASSERT_EQ(run({"resume", "c", "--spp", "32", "-o", "b.pfm", "--threads", "3"}).exit_code, 0);
  EXPECT_TRUE(bytes("b.pfm") == bytes("alone.pfm"));
}

// A checkpoint must distinguish the user's settings from derived ones.
TEST_F(CheckpointCli, ResumedRenderHasTheSettingsOfTheOneBefore) {
  const std::string few = "bootstrap=3000";
  const std::vector<std::vector<std::string>> settings = {
      {"masked", "pilot=keep", few},
      {"masked", "lambertian=omc", "omc=lt", few},
      {"masked", "chain=pssmlt", "omc=lt", few},
      {"selective", "chain=mlt"},
      {"mmlt", "step=adaptive", few},
      {"mmlt", "mutation=fusion", few},
      {"pssmlt", "mutation=gaussian", few},
      {"mlt", "manifold=0.5", few},
      {"erpt", "chain=pssmlt", few}};
  for (const std::vector<std::string>& setting : settings) {
    std::vector<std::string> arguments{"--integrator", setting.front()};
    for (std::size_t i = 1; i < setting.size(); ++i) {
      arguments.insert(arguments.end(), {"--set", setting[i]});
    }
    const auto render = [&](std::vector<std::string> more) {
      more.insert(more.end(), arguments.begin(), arguments.end());
      return Cli::render(more);
    };
    const std::string what = setting[0] + ", " + setting[1];
    fs::remove(folder_ / "c");
    ASSERT_EQ(render({"--spp", "32", "-o", "alone.pfm"}).exit_code, 0) << what;
    ASSERT_EQ(render({"--spp", "8", "-o", "a.pfm", "--checkpoint", "c"}).exit_code, 0) << what;
    const Outcome resumed = run({"resume", "c", "--spp", "32", "--stats", "stats.json"});
    ASSERT_EQ(resumed.exit_code, 0) << what << ": " << resumed.err;
    EXPECT_TRUE(bytes("a.pfm") == bytes("alone.pfm")) << what;
    if (setting[1] == "pilot=keep") {
      EXPECT_EQ(statistics().at("parameters").at("pilot"), "keep");
      EXPECT_EQ(statistics().at("parameters").at("omc"), "ibpt") << "defaults are told";
    }
  }
}

TEST_F(CheckpointCli, FinishedRenderIsShownAgainWithoutRendering) {
  ASSERT_EQ(render({"--spp", "8", "-o", "a.pfm", "--checkpoint", "c"}).exit_code, 0);
  const std::string before = bytes("c");
  ASSERT_EQ(run({"resume", "c", "-o", "b.pfm", "-o", "b.png", "--exposure", "1"}).exit_code, 0);
  EXPECT_EQ(bytes("a.pfm"), bytes("b.pfm"));
  EXPECT_EQ(bytes("c"), before);
}

TEST_F(CheckpointCli, RenderResumesFromItsCheckpoint) {
  ASSERT_EQ(render({"--spp", "24", "-o", "alone.pfm"}).exit_code, 0);
  const auto begin_or_go_on = [&](const char* spp, const char* output) {
    return render({"--spp", spp, "-o", output, "--checkpoint", "c", "--resume", "c"});
  };
  EXPECT_TRUE(contains(begin_or_go_on("8", "a.pfm").err, "begins anew"));
  const Outcome second = begin_or_go_on("24", "b.pfm");
  EXPECT_EQ(second.exit_code, 0) << second.err;
  EXPECT_TRUE(bytes("b.pfm") == bytes("alone.pfm"));
  const Outcome other = render({"--spp", "24", "--seed", "3", "--resume", "c", "-o", "c.pfm"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_TRUE(contains(other.err, "seed 0, not seed 3")) << other.err;
}

TEST_F(CheckpointCli, UnusableCheckpointsAreRefused) {
  EXPECT_EQ(run({"resume", "absent"}).exit_code, 4);
  file("text", "no checkpoint, but longer than the header of one, so that there is some to read");
  EXPECT_EQ(run({"resume", "text"}).exit_code, 4);
  ASSERT_EQ(run({"convert", "builtin:cornell", "room.pbrt"}).exit_code, 0);
  ASSERT_EQ(run({"render", "room.pbrt", "--resolution", "24x16", "--spp", "4", "-o", "a.pfm",
                 "--checkpoint", "c"})
                .exit_code,
            0);
  std::string whole = bytes("c");
  std::ofstream(folder_ / "short", std::ios::binary) << whole.substr(0, whole.size() / 2);
  const Outcome cut = run({"resume", "short"});
  EXPECT_EQ(cut.exit_code, 4);
  EXPECT_TRUE(contains(cut.err, "cut short")) << cut.err;
  whole[whole.size() / 2] = static_cast<char>(whole[whole.size() / 2] ^ 1);
  std::ofstream(folder_ / "damaged", std::ios::binary) << whole;
  const Outcome damaged = run({"resume", "damaged"});
  EXPECT_EQ(damaged.exit_code, 4);
  EXPECT_TRUE(contains(damaged.err, "damaged")) << damaged.err;
  // The scene changes.
  std::ofstream(folder_ / "room.pbrt", std::ios::app)
      << "AttributeBegin\nTranslate 0 0 0\nShape \"sphere\" \"float radius\" 0.1\nAttributeEnd\n";
  std::string text = read_text(folder_ / "room.pbrt");
  const std::size_t end = text.find("WorldEnd");
  if (end != std::string::npos) text.erase(end, 8);
  std::ofstream(folder_ / "room.pbrt", std::ios::trunc) << text;
  for (const char* force : {"--progress=none", "--force"}) {
    const Outcome changed = run({"resume", "c", "--spp", "8", force});
    EXPECT_EQ(changed.exit_code, 2) << changed.err;
    EXPECT_TRUE(contains(changed.err, "changed")) << changed.err;
  }
}

TEST_F(CheckpointCli, CorruptCheckpointsAreRefused) {
  ASSERT_EQ(
      render({"--spp", "4", "--checkpoint", "c", "-o", "a.pfm", "--tone-map", "filmic"}).exit_code,
      0);
  const std::string good = bytes("c");
  const auto expect_refused = [&](std::size_t place, std::string_view value) {
    std::string bad = good;
    bad.replace(place, value.size(), value);
    make_checkpoint_checksums_right(std::as_writable_bytes(std::span(bad)));
    std::ofstream(file("c"), std::ios::binary | std::ios::trunc) << bad;
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"resume", "c", "--force"}, {"merge", "c", "-o", "b.pfm"}}) {
      const Outcome outcome = run(arguments);
      EXPECT_EQ(outcome.exit_code, 4) << arguments[0] << " " << place << " " << outcome.err;
      EXPECT_TRUE(contains(outcome.err, "c: makes no sense: ")) << outcome.err;
    }
  };
  // The tone map, and the number of bytes of its name.
  const std::size_t tone_map = good.find("filmic");
  ASSERT_NE(tone_map, std::string::npos);
  expect_refused(tone_map, "none");
  expect_refused(tone_map - 8, std::string_view("\xff\xff\xff\xff\xff\xff\xff\x7f", 8));
}

TEST_F(CheckpointCli, MovedSceneNeedsForce) {
  fs::create_directories(folder_ / "old");
  // With an image, whose path counts.
  const Outcome made = render({"--spp", "1", "-o", "old/image.png"});
  ASSERT_EQ(made.exit_code, 0);
  std::ofstream(folder_ / "old" / "room.pbrt")
      << "Film \"image\" \"integer xresolution\" 24 \"integer yresolution\" 16\nCamera "
         "\"perspective\"\nWorldBegin\nLightSource \"infinite\"\nTexture \"t\" \"spectrum\" "
         "\"imagemap\" \"string filename\" \"image.png\"\nMaterial \"matte\" \"texture Kd\" "
         "\"t\"\nTranslate 0 0 3\nShape \"sphere\"\nWorldEnd\n";
  ASSERT_EQ(run({"render", "old/room.pbrt", "--spp", "8", "-o", "alone.pfm"}).exit_code, 0);
  ASSERT_EQ(
      run({"render", "old/room.pbrt", "--spp", "4", "-o", "a.pfm", "--checkpoint", "c"}).exit_code,
      0);
  fs::rename(folder_ / "old", folder_ / "new");
  EXPECT_EQ(run({"resume", "c", "--spp", "8"}).exit_code, 4) << "it is not there";
  const Outcome moved = run({"resume", "c", "--spp", "8", "--scene", "new/room.pbrt"});
  EXPECT_EQ(moved.exit_code, 2) << moved.err;
  EXPECT_TRUE(contains(moved.err, "--force")) << moved.err;
  const Outcome forced = run({"resume", "c", "--spp", "8", "--scene", "new/room.pbrt", "--force"});
  EXPECT_EQ(forced.exit_code, 0) << forced.err;
  EXPECT_EQ(bytes("a.pfm"), bytes("alone.pfm"));
}

TEST_F(CheckpointCli, InterruptsWriteThePictureAndTheCheckpoint) {
  // The second of them in the middle of a pass. (Of every method: resume_test.cpp.)
  for (const auto& [count, integrator, setting] :
       {std::tuple(1, "mmlt", "bootstrap=10000"), std::tuple(2, "pt", "heuristic=power")}) {
    const pid_t child = start_endless(
        {"--checkpoint", "c", "--integrator", integrator, "--set", setting}, "160x100");
    for (int i = 0; i < count; ++i) kill(child, i == 0 ? SIGINT : SIGTERM);
    const Outcome outcome = finish(child);
    EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
    EXPECT_EQ(read_image(file("a.exr").string()).width, 160);
    EXPECT_EQ(statistics().at("interruptions"), 1);
    const auto samples = statistics().at("samples_per_pixel").get<std::uint64_t>();
    // A pass that was cut short is finished; it may have been as long as all before.
    const std::string more = std::to_string(2 * samples + 8);
    const Outcome resumed =
        run({"resume", "c", "--spp", more, "-o", "b.pfm", "--stats", "stats.json"});
    ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
    EXPECT_EQ(statistics().at("complete"), true);
    EXPECT_EQ(statistics().at("interruptions"), 1);
    ASSERT_EQ(run({"render", "builtin:cornell", "--resolution", "160x100", "--spp", more, "-o",
                   "alone.pfm", "--integrator", integrator, "--set", setting})
                  .exit_code,
              0);
    // Not EXPECT_EQ, which would print them.
    EXPECT_TRUE(bytes("b.pfm") == bytes("alone.pfm"));
    for (const char* name : {".stderr", "c"}) fs::remove(folder_ / name);
  }
}

/// Renders interrupted before their chains are prepared are shown, but cannot be resumed: they are
/// not the requested render.
TEST_F(CheckpointCli, AnInterruptedPreparationLeavesAPictureAndNoCheckpoint) {
  const std::vector<std::string> arguments = {"render",       "builtin:cornell",
                                              "--integrator", "selective",
                                              "--resolution", "640x400",
                                              "--spp",        "1000",
                                              "--threads",    "1",
                                              "--progress",   "json",
                                              "--stats",      "stats.json",
                                              "-o",           "a.exr",
                                              "--aov",        "density",
                                              "--checkpoint", "c"};
  const pid_t child = start(arguments);
  EXPECT_TRUE(wait_for(folder_ / ".stderr", "\"progress\",\"phase\":\"prepare\""));
  kill(child, SIGINT);
  const Outcome outcome = finish(child);
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  EXPECT_EQ(statistics().at("prepared"), false);
  EXPECT_EQ(statistics().at("samples_per_pixel"), 1);
  EXPECT_TRUE(contains(outcome.err, "the render itself has not begun")) << outcome.err;
  const std::vector<float> rgb = read_image(file("a.exr").string()).rgb();
  EXPECT_GT(*std::max_element(rgb.begin(), rgb.end()), 0.F);
  EXPECT_FALSE(fs::exists(folder_ / "c"));
}

TEST_F(CheckpointCli, TwoSignalsWhilePreparingHaveMessages) {
  const pid_t child = start({"render", "builtin:cornell", "--integrator", "selective",
                             "--resolution", "640x400", "--spp", "1000", "--threads", "1",
                             "--progress", "json", "-o", "a.exr", "--checkpoint", "c"});
  EXPECT_TRUE(wait_for(folder_ / ".stderr", "\"progress\",\"phase\":\"prepare\""));
  for (const int signal : {SIGINT, SIGTERM}) kill(child, signal);
  const Outcome outcome = finish(child);
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "nothing was rendered")) << outcome.err;
  EXPECT_FALSE(fs::exists(folder_ / "a.exr"));
  EXPECT_FALSE(fs::exists(folder_ / "c"));
}

TEST_F(CheckpointCli, ARenderTooShortForItsPreparationDoesWithout) {
  ASSERT_EQ(
      run({"render", "builtin:cornell", "--integrator", "selective", "--resolution", "320x200",
           "--time", "0.05s", "--stats", "stats.json", "-o", "a.exr", "--aov", "noise"})
          .exit_code,
      0);
  EXPECT_EQ(statistics().at("prepared"), false);
  EXPECT_GE(statistics().at("samples_per_pixel"), 1);
  EXPECT_FALSE(statistics().contains("selective"));
}

TEST_F(CheckpointCli, HangUpAndUserSignalWriteThePictureAndGoOn) {
  const pid_t child = start_endless({});
  for (const int signal : {SIGHUP, SIGUSR1}) {
    fs::remove(folder_ / "a.exr");
    kill(child, signal);
    EXPECT_TRUE(wait_for_file(folder_ / "a.exr")) << signal;
    EXPECT_EQ(read_image(file("a.exr").string()).width, 32);
  }
  EXPECT_EQ(kill(child, SIGINT), 0) << "it still runs";
  EXPECT_EQ(finish(child).exit_code, 130);
}

/// At a size at which memory goes back to the system when a picture is gone.
TEST_F(CheckpointCli, APictureOfALongRenderIsThePictureOfItsEnd) {
  const pid_t child = start_endless({"-o", "a.png", "--integrator", "pt"}, "320x240");
  kill(child, SIGUSR1);
  EXPECT_TRUE(wait_for(folder_ / ".stderr", "wrote the picture"));
  const std::vector<float> early = read_image(file("a.exr").string()).rgb();
  const std::vector<float> early_shown = read_image(file("a.png").string()).data;
  kill(child, SIGINT);
  EXPECT_EQ(finish(child).exit_code, 130);
  const std::vector<float> late = read_image(file("a.exr").string()).rgb();
  const std::vector<float> late_shown = read_image(file("a.png").string()).data;
  ASSERT_EQ(early.size(), std::size_t{3} * 320 * 240);
  ASSERT_EQ(late.size(), early.size());
  ASSERT_EQ(late_shown.size(), early_shown.size());
  // In blocks of 32 rows: few samples per pixel, but 30 720 of them.
  constexpr std::size_t kBlock = std::size_t{3} * 320 * 32;
  for (std::size_t first = 0; first < early.size(); first += kBlock) {
    double sums[4] = {};
    for (std::size_t i = first; i < std::min(first + kBlock, early.size()); ++i) {
      ASSERT_TRUE(std::isfinite(early[i])) << i;
      sums[0] += static_cast<double>(early[i]);
      sums[1] += static_cast<double>(late[i]);
      sums[2] += static_cast<double>(early_shown[i]);
      sums[3] += static_cast<double>(late_shown[i]);
    }
    EXPECT_NEAR(sums[0] / sums[1], 1.0, 0.1) << "from value " << first;
    EXPECT_NEAR(sums[2] / sums[3], 1.0, 0.2) << "from value " << first;
  }
}

TEST_F(CheckpointCli, PicturesAreWrittenWhileRendering) {
  const pid_t child = start_endless({"--output-every", "0.1s"});
  for (int round = 0; round < 2; ++round) {
    fs::remove(folder_ / "a.exr");
    EXPECT_TRUE(wait_for_file(folder_ / "a.exr"));
  }
  kill(child, SIGKILL);
  finish(child);
}

TEST_F(CheckpointCli, VanishedFolderIsReportedAndNothingIsLost) {
  fs::create_directories(folder_ / "out");
  const pid_t child = start_endless({"--checkpoint", "out/c", "--checkpoint-every", "0.1s", "-o",
                                     "out/b.pfm", "--output-every", "0.1s"});
  // All at once: the child may write a file into a folder that is being emptied.
  fs::rename(folder_ / "out", folder_ / "gone");
  fs::remove_all(folder_ / "gone");
  EXPECT_TRUE(wait_for(folder_ / ".stderr", "the checkpoint will be tried again"));
  EXPECT_TRUE(wait_for(folder_ / ".stderr", "the picture will be tried again"));
  kill(child, SIGINT);
  const Outcome outcome = finish(child);
  EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "there is no folder")) << outcome.err;
  int rescued = 0;
  for (const auto& entry : fs::directory_iterator(folder_)) {
    const std::string name = entry.path().filename().string();
    if (!contains(name, "-rescued-")) continue;
    ++rescued;
    if (name.starts_with("c-")) {
      EXPECT_EQ(run({"resume", name, "--time", "0.001s", "-o", "x.pfm"}).exit_code, 0);
    }
  }
  EXPECT_EQ(rescued, 2) << outcome.err;
}

TEST_F(CheckpointCli, TheRestoredFolderIsUsedAgain) {
  fs::create_directories(folder_ / "out");
  const pid_t child = start_endless({"--checkpoint", "out/c", "--checkpoint-every", "0.1s"});
  fs::rename(folder_ / "out", folder_ / "gone");
  EXPECT_TRUE(wait_for(folder_ / ".stderr", "the checkpoint will be tried again"));
  fs::create_directories(folder_ / "out");
  EXPECT_TRUE(wait_for(folder_ / ".stderr", "the checkpoint could be written again"));
  kill(child, SIGKILL);
  finish(child);
  EXPECT_EQ(run({"resume", "out/c", "--time", "0.001s", "-o", "x.pfm"}).exit_code, 0);
}

TEST_F(CheckpointCli, FullDiskLeavesThePreviousCheckpoint) {
  ASSERT_EQ(render({"--spp", "8", "-o", "a.pfm", "--checkpoint", "c"}).exit_code, 0);
  // A full disk: no file of the child can become longer than this.
  const auto size = fs::file_size(folder_ / "c");
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit full = before;
  full.rlim_cur = size / 2;
  setrlimit(RLIMIT_FSIZE, &full);
  const pid_t child = start({"resume", "c", "--spp", "16", "-o", "b.pfm"});
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_TRUE(wait_for(folder_ / ".stderr", "the checkpoint waits until there is room"));
  kill(child, SIGINT);
  const Outcome outcome = finish(child);
  EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
  EXPECT_EQ(fs::file_size(folder_ / "c"), size);
  EXPECT_TRUE(fs::exists(folder_ / "b.pfm")) << "the picture is smaller";
  const Outcome again = run({"resume", "c", "--spp", "16", "-o", "b.pfm"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
}

TEST_F(CheckpointCli, FullDiskIsReportedAndTheRenderGoesOn) {
  // Writing there fails as on a full disk.
  fs::create_symlink("/dev/full", folder_ / "b.pfm");
  const pid_t child = start_endless({"-o", "b.pfm", "--output-every", "0.1s"});
  EXPECT_TRUE(wait_for(folder_ / ".stderr", "the picture will be tried again, the render goes on"));
  EXPECT_TRUE(wait_for(folder_ / ".stderr", "No space left on device"));
  fs::remove(folder_ / "b.pfm");
  EXPECT_TRUE(wait_for(folder_ / ".stderr", "the picture could be written again"));
  EXPECT_TRUE(fs::exists(folder_ / "b.pfm"));
  kill(child, SIGINT);
  EXPECT_EQ(finish(child).exit_code, 130);
}

TEST_F(CheckpointCli, PreviewShowsThePictureInAViewer) {
  FakeViewer viewer(FakeViewer::Manners::Good);
  const std::string where = "127.0.0.1:" + std::to_string(viewer.port());
  const Outcome outcome = render({"--spp", "16", "-o", "a.pfm", "--preview", where});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  ASSERT_EQ(render({"--spp", "16", "-o", "b.pfm"}).exit_code, 0);
  EXPECT_EQ(bytes("a.pfm"), bytes("b.pfm"));
  EXPECT_EQ(viewer.fault(), "");
  // The connection may be younger than the render, which then has no viewer for its picture.
  const pid_t child = start_endless({"--preview", where, "--aov", "albedo"});
  EXPECT_TRUE(wait_until([&] { return viewer.picture("ajar: cornell").updates > 0; }));
  kill(child, SIGINT);
  EXPECT_EQ(finish(child).exit_code, 130);
  const FakeViewer::Picture shown = viewer.picture("ajar: cornell");
  EXPECT_EQ(shown.width, 32);
  EXPECT_EQ(shown.channels.count("albedo.G"), 1U);
  for (const char* nonsense : {"host:port", "no such host:1"}) {
    EXPECT_EQ(render({"--spp", "1", "--preview", nonsense}).exit_code, 2) << nonsense;
  }
}

TEST_F(CheckpointCli, SharesNeedACheckpointAndEqualSamples) {
  EXPECT_EQ(render({"--share", "1/2", "--spp", "4"}).exit_code, 2);
  EXPECT_EQ(render({"--share", "3/2", "--spp", "4", "--checkpoint", "c"}).exit_code, 2);
  EXPECT_EQ(render({"--share", "1/2", "--target-error", "0.1", "--checkpoint", "c"}).exit_code, 2);
}

TEST_F(CheckpointCli, MergedSharesHaveTheBitsOfTheWhole) {
  const auto render = [&](std::vector<std::string> more) {
    more.insert(more.end(), {"--integrator", "ibpt"});
    return Cli::render(more);
  };
  ASSERT_EQ(render({"--spp", "12", "-o", "alone.pfm"}).exit_code, 0);
  for (const char* share : {"1/3", "2/3", "3/3"}) {
    const std::string name = std::string("share-") + share[0];
    const Outcome part =
        render({"--spp", "8", "--share", share, "--checkpoint", name, "-o", name + ".pfm"});
    ASSERT_EQ(part.exit_code, 0) << part.err;
    // A share can be extended like a whole.
    ASSERT_EQ(run({"resume", name, "--spp", "12"}).exit_code, 0);
  }
  const Outcome missing = run({"merge", "share-1", "share-3", "-o", "b.pfm"});
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_TRUE(contains(missing.err, "share 2/3 of seed 0 is missing")) << missing.err;
  const Outcome merged =
      run({"merge", "share-2", "share-1", "share-3", "-o", "b.pfm", "--checkpoint", "whole"});
  ASSERT_EQ(merged.exit_code, 0) << merged.err;
  EXPECT_TRUE(bytes("b.pfm") == bytes("alone.pfm"));
  ASSERT_EQ(render({"--spp", "20", "-o", "alone.pfm"}).exit_code, 0);
  ASSERT_EQ(run({"resume", "whole", "--spp", "20", "-o", "b.pfm"}).exit_code, 0);
  EXPECT_TRUE(bytes("b.pfm") == bytes("alone.pfm")) << "the whole goes on";
}

TEST_F(CheckpointCli, MergedSeedsMakeABetterPicture) {
  for (const char* seed : {"1", "2", "3", "4"}) {
    const Outcome part =
        render({"--spp", "256", "--seed", seed, "--checkpoint", std::string("seed-") + seed,
                "--stats", "one.json", "-o", "a.pfm", "--integrator", "pt"});
    ASSERT_EQ(part.exit_code, 0) << part.err;
  }
  const Outcome merged = run({"merge", "seed-1", "seed-2", "seed-3", "seed-4", "-o", "all.exr",
                              "--stats", "stats.json", "--checkpoint", "all"});
  ASSERT_EQ(merged.exit_code, 0) << merged.err;
  EXPECT_EQ(statistics().at("samples_per_pixel"), 1024);
  EXPECT_EQ(statistics().at("samples"), 1024 * 24 * 16);
  const auto error = [](const json& s) { return s.at("estimated_relative_error").get<double>(); };
  // 1152 values with 3 degrees of freedom: the quotient's standard error is about 2 %. Pixels that
  // are still mostly noise count less than they should in the larger of the two.
  const double quotient = error(statistics()) / error(statistics("one.json"));
  EXPECT_GT(quotient, 0.45);
  EXPECT_LT(quotient, 0.6);
  const Outcome on = run({"resume", "all", "--spp", "2048"});
  EXPECT_EQ(on.exit_code, 2);
  EXPECT_TRUE(contains(on.err, "merge of several seeds")) << on.err;
  EXPECT_EQ(run({"merge", "all", "seed-2", "-o", "b.pfm"}).exit_code, 2) << "seed 2 twice";
  EXPECT_EQ(run({"merge", "seed-1", "seed-2"}).exit_code, 2) << "where to?";
}

/// A few kills of the whole program, or as many as the environment's AJAR_KILLS says; a hundred of
/// a render without it are in soak_test.cpp.
TEST_F(CheckpointCli, KilledAgainAndAgainItEndsWithTheSameBits) {
  // Tests run one after the other. NOLINTNEXTLINE(concurrency-mt-unsafe)
  const char* const asked = std::getenv("AJAR_KILLS");
  const int kills = asked == nullptr ? 8 : std::stoi(asked);
  const std::vector<std::string> arguments = {"render",
                                              "builtin:cornell",
                                              "--resolution",
                                              "48x32",
                                              "--spp",
                                              "200",
                                              "--progress",
                                              "none",
                                              "--threads",
                                              "1",
                                              "-o",
                                              "soak.pfm",
                                              "--checkpoint",
                                              "c",
                                              "--resume",
                                              "c",
                                              "--integrator",
                                              "bdpt",
                                              "--checkpoint-every",
                                              "0.01s"};
  std::mt19937 random(11);
  for (int i = 0; i < kills; ++i) {
    const pid_t child = start(arguments);
    std::this_thread::sleep_for(std::chrono::milliseconds(200 + random() % 500));
    kill(child, SIGKILL);
    const Outcome outcome = finish(child);
    ASSERT_TRUE(outcome.exit_code == -SIGKILL || outcome.exit_code == 0)
        << outcome.exit_code << " " << outcome.err;
  }
  ASSERT_EQ(run(arguments).exit_code, 0);
  const std::string soaked = bytes("soak.pfm");
  for (const auto& entry : fs::directory_iterator(folder_)) {
    EXPECT_FALSE(contains(entry.path().filename().string(), ".partial")) << entry.path();
  }
  fs::remove(folder_ / "c");
  ASSERT_EQ(run(arguments).exit_code, 0);
  EXPECT_EQ(soaked, bytes("soak.pfm"));
}

}  // namespace
}  // namespace ajar
