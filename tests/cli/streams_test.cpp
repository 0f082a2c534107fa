// Renders with unreadable streams.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "cli/cli_fixture.h"
#include "cli/lost_streams.h"
#include "imageio/image_file.h"

namespace ajar {
namespace {

class StreamsCli : public Cli {
 protected:
  /// A command with more arguments, which leaves `file` behind, and says something about it.
  struct Command {
    std::vector<std::string> arguments;
    std::string file;
  };
  std::vector<Command> commands() const {
    const std::vector<std::string> small = {"render", "builtin:cornell", "--resolution",
                                            "24x16",  "--spp",           "4"};
    const auto with = [&](std::vector<std::string> more) {
      more.insert(more.begin(), small.begin(), small.end());
      return more;
    };
    for (const char* seed : {"1", "2"}) {
      EXPECT_EQ(run(with({"--seed", seed, "--checkpoint", std::string("c") + seed, "-o", "s.pfm"}))
                    .exit_code,
                0);
    }
    file("study.json", R"({"scenes": ["builtin:cornell"], "resolution": "16x12", "depth": 4,
        "threads": 1, "integrators": ["pt"], "seeds": 1, "metrics": ["relmse"],
        "reference": {"integrator": "pt", "spp": 4}, "budgets": [{"spp": 4}]})");
    return {{with({"-o", "a.pfm"}), "a.pfm"},
            {with({"--progress", "json", "-o", "b.pfm"}), "b.pfm"},
            {{"resume", "c1", "--spp", "8", "-o", "r.pfm"}, "r.pfm"},
            {{"merge", "c1", "c2", "-o", "m.pfm", "--force"}, "m.pfm"},
            {{"study", "study.json", "--out", "out"}, "out/study.md"},
            {{"info", "builtin:cornell"}, ""}};
  }
};

TEST_F(StreamsCli, MessagesThatCannotBeWrittenAreDropped) {
  for (const Command& command : commands()) {
    for (const auto& [how, change] : lost_streams(STDERR_FILENO)) {
      if (!command.file.empty()) fs::remove_all(folder_ / command.file);
      const Outcome outcome = finish(start(command.arguments, AJAR_PROGRAM, change));
      EXPECT_EQ(outcome.exit_code, 0) << command.arguments[0] << " with stderr " << how;
      EXPECT_TRUE(command.file.empty() || fs::exists(folder_ / command.file))
          << command.arguments[0] << " with stderr " << how;
    }
  }
}

TEST_F(StreamsCli, ErrorsThatCannotBeWrittenKeepTheirExitCode) {
  for (const auto& [how, change] : lost_streams(STDERR_FILENO)) {
    EXPECT_EQ(finish(start({"render", "nothing.pbrt"}, AJAR_PROGRAM, change)).exit_code, 4) << how;
    EXPECT_EQ(finish(start({"rendr"}, AJAR_PROGRAM, change)).exit_code, 2) << how;
  }
}

TEST_F(StreamsCli, AResultThatCannotBeWrittenIsAnErrorButAPictureIsThere) {
  const auto full = lost_streams(STDOUT_FILENO).front();
  ASSERT_EQ(full.first, "full");
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"info", "builtin:cornell"},
        {"info", "builtin:cornell", "--json"},
        {"list"},
        {"--help"},
        {"--version"}}) {
    const Outcome outcome = finish(start(command, AJAR_PROGRAM, full.second));
    EXPECT_EQ(outcome.exit_code, 4) << command[0];
    EXPECT_TRUE(contains(outcome.err, "standard output")) << outcome.err;
  }
  const Outcome outcome = finish(
      start({"render", "builtin:cornell", "--resolution", "24x16", "--spp", "1", "-o", "a.pfm"},
            AJAR_PROGRAM, full.second));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(fs::exists(folder_ / "a.pfm"));
}

TEST_F(StreamsCli, ClosedPipeIsNoError) {
  for (const auto& [how, change] : lost_streams(STDOUT_FILENO)) {
    if (how != "a pipe without a reader") continue;
    const Outcome outcome = finish(start({"list"}, AJAR_PROGRAM, change));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
  }
}

TEST_F(StreamsCli, FilesDoNotTakeThePlaceOfClosedStreams) {
  const auto close_all = [] {
    for (const int descriptor : {0, 1, 2}) close(descriptor);
  };
  const Outcome outcome = finish(start({"render", "builtin:cornell", "--resolution", "24x16",
                                        "--spp", "4", "-o", "a.pfm", "--stats", "stats.json"},
                                       AJAR_PROGRAM, close_all));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(read_image(file("a.pfm").string()).width, 24);
  EXPECT_EQ(statistics().at("samples_per_pixel"), 4);
}

/// An endless render in a terminal of its own.
class TerminalCli : public StreamsCli {
 protected:
  void SetUp() override {
    StreamsCli::SetUp();
    ASSERT_EQ(openpty(&screen_, &terminal_, nullptr, nullptr, nullptr), 0);
    fcntl(screen_, F_SETFD, FD_CLOEXEC);
    child_ = start(
        {"render", "builtin:cornell", "--resolution", "32x24", "--time", "1h", "--threads", "1",
         "-o", "a.pfm", "--checkpoint", "c", "--checkpoint-every", "1h", "--stats", "stats.json"},
        AJAR_PROGRAM, [this] {
          setsid();
          ioctl(terminal_, TIOCSCTTY, 0);
          for (const int descriptor : {0, 1, 2}) dup2(terminal_, descriptor);
          close(terminal_);
        });
    close(terminal_);
  }
  /// Until the render shows samples.
  bool wait_for_samples() const {
    std::string seen;
    return wait_until([&] {
      char text[4096];
      const ssize_t size = read(screen_, text, sizeof(text));
      if (size > 0) seen.append(text, static_cast<std::size_t>(size));
      return contains(seen, "spp");
    });
  }
  int screen_ = -1;
  int terminal_ = -1;
  pid_t child_ = 0;
};

TEST_F(TerminalCli, ClosedTerminalDoesNotStopARender) {
  ASSERT_TRUE(wait_for_samples());
  close(screen_);
  // The hang-up asks for the picture, and the render goes on.
  EXPECT_TRUE(wait_for_file(folder_ / "a.pfm"));
  EXPECT_EQ(kill(child_, 0), 0);
  kill(child_, SIGINT);
  EXPECT_EQ(finish(child_).exit_code, 130);
  EXPECT_TRUE(fs::exists(folder_ / "c"));
  EXPECT_EQ(statistics().at("interruptions"), 1);
}

TEST_F(TerminalCli, StalledReaderDoesNotStopARender) {
  ASSERT_TRUE(wait_for_samples());
  // Stops the output like Ctrl-S.
  const char stop = 19;
  ASSERT_EQ(write(screen_, &stop, 1), 1);
  kill(child_, SIGUSR1);
  EXPECT_TRUE(wait_for_file(folder_ / "a.pfm"));
  kill(child_, SIGINT);
  EXPECT_TRUE(wait_for_file(folder_ / "stats.json"));
  EXPECT_EQ(finish(child_).exit_code, 130);
  close(screen_);
}

}  // namespace
}  // namespace ajar
