// Several processes of mpirun that render one picture, as a user meets them.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <string>

#include "cli/cli_fixture.h"
#include "cli/lost_streams.h"

namespace ajar {
namespace {

class MpiCli : public Cli {
 protected:
  std::string bytes(const std::string& name) const { return read_text(folder_ / name); }
#ifdef AJAR_MPIRUN
  pid_t start_ranks(int count, const std::vector<std::string>& arguments,
                    const std::function<void()>& change = {}) const {
    // Tests may be run by root in a container with fewer processors than ranks.
    std::vector<std::string> all{"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1",
                                 "OMPI_MCA_rmaps_base_oversubscribe=1",
                                 // Open MPI frees little, and its plug-ins are gone by then, so
                                 // that no list of known leaks can name them.
                                 "ASAN_OPTIONS=detect_leaks=0:strict_string_checks=1", AJAR_MPIRUN,
                                 "-n", std::to_string(count), AJAR_PROGRAM};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return start(all, "/usr/bin/env", change);
  }
  Outcome run_ranks(int count, const std::vector<std::string>& arguments) const {
    return finish(start_ranks(count, arguments));
  }
#endif
};

TEST_F(MpiCli, ProgramDoesNotLinkMpi) {
  for (const char* file : {AJAR_PROGRAM, AJAR_LIBRARY}) {
    const std::string bytes = read_text(file);
    ASSERT_GT(bytes.size(), 1000U) << file;
    EXPECT_FALSE(contains(bytes, "libmpi")) << file;
    EXPECT_FALSE(contains(bytes, "MPI_Init")) << file;
  }
}

TEST_F(MpiCli, WithoutItsMpiModuleTheProgramRefusesToBeARank) {
  fs::copy_file(AJAR_PROGRAM, folder_ / "ajar");
  const std::string copy = (folder_ / "ajar").string();
  const Outcome outcome =
      finish(start({"OMPI_COMM_WORLD_SIZE=2", copy, "render", "builtin:cornell"}, "/usr/bin/env"));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.err, "built without MPI")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "apt-get install libopenmpi-dev openmpi-bin")) << outcome.err;
  const Outcome help = finish(start({"bash", AJAR_SOURCE_DIR "/dev", "help"}, "/usr/bin/env"));
  EXPECT_TRUE(contains(help.out, "libopenmpi-dev and openmpi-bin")) << help.out;
}

#ifdef AJAR_MPIRUN

std::vector<std::string> small_render(const std::string& integrator, const std::string& output) {
  // The default bootstrap takes longer than all the rest.
  const std::string setting = integrator == "bdpt"        ? "cull=0"
                              : integrator == "selective" ? "split=1"
                                                          : "bootstrap=5000";
  return {"render",  "builtin:cornell", "--resolution", "24x16",     "--spp", "24", "--progress",
          "none",    "--integrator",    integrator,     "--threads", "1",     "-o", output,
          "--stats", "stats.json",      "--set",        setting};
}

TEST_F(MpiCli, AnyNumberOfRanksGivesTheSameFile) {
  // Two and three take turns. (Both, on threads: resume_test.cpp.)
  int count = 2;
  for (const std::string integrator :
       {"bdpt", "pssmlt", "mmlt", "mlt", "erpt", "masked", "selective"}) {
    ASSERT_EQ(run(small_render(integrator, "one.pfm")).exit_code, 0);
    const json alone = statistics();
    const Outcome outcome = run_ranks(count, small_render(integrator, "several.pfm"));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(bytes("several.pfm"), bytes("one.pfm")) << integrator << " on " << count;
    const json together = statistics();
    EXPECT_EQ(together.at("ranks"), count);
    // Not the rays: chains that are started more often trace more.
    for (const char* key :
         {"mutations", "samples", "samples_per_pixel", "estimated_relative_error"}) {
      EXPECT_EQ(together.at(key), alone.at(key)) << key;
    }
    count = 5 - count;
  }
}

TEST_F(MpiCli, MessagesThatCannotBeWrittenAreDropped) {
  std::vector<std::string> with_checkpoint = small_render("bdpt", "a.pfm");
  with_checkpoint.insert(with_checkpoint.end(), {"--checkpoint", "c"});
  file("study.json", R"({"scenes": ["builtin:cornell"], "resolution": "16x12", "depth": 4,
      "threads": 1, "integrators": ["pt"], "seeds": 1, "metrics": ["relmse"],
      "reference": {"integrator": "pt", "spp": 4}, "budgets": [{"spp": 4}]})");
  const std::vector<std::pair<std::vector<std::string>, std::string>> commands = {
      {with_checkpoint, "a.pfm"},
      {{"resume", "c", "--spp", "32", "-o", "r.pfm"}, "r.pfm"},
      {{"merge", "c", "-o", "m.pfm"}, "m.pfm"},
      {{"study", "study.json", "--out", "out"}, "out/study.md"},
      {{"info", "builtin:cornell"}, ".stdout"}};
  for (const auto& [arguments, written] : commands) {
    for (const auto& [how, change] : lost_streams(STDERR_FILENO)) {
      if (how != "full" && arguments != with_checkpoint) continue;
      for (const std::string& name : {written, std::string("c")}) {
        if (arguments == with_checkpoint || name == written) fs::remove(folder_ / name);
      }
      const Outcome outcome = finish(start_ranks(2, arguments, change));
      EXPECT_EQ(outcome.exit_code, 0) << arguments[0] << " with stderr " << how;
      EXPECT_TRUE(fs::exists(folder_ / written)) << arguments[0] << " with stderr " << how;
    }
  }
}

TEST_F(MpiCli, CheckpointsGoFromRanksToOneProcessAndBack) {
  std::vector<std::string> arguments = small_render("selective", "a.pfm");
  arguments.insert(arguments.end(), {"--checkpoint", "c"});
  ASSERT_EQ(run_ranks(2, arguments).exit_code, 0);
  ASSERT_EQ(run({"resume", "c", "--spp", "40"}).exit_code, 0);
  const Outcome outcome = run_ranks(3, {"resume", "c", "--spp", "64", "--threads", "1"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  arguments = small_render("selective", "alone.pfm");
  std::replace(arguments.begin(), arguments.end(), std::string("24"), std::string("64"));
  ASSERT_EQ(run(arguments).exit_code, 0);
  EXPECT_EQ(bytes("a.pfm"), bytes("alone.pfm"));
}

TEST_F(MpiCli, ErrorsAreReportedOnceAndEndAllRanks) {
  const Outcome outcome = run_ranks(2, {"render", "builtin:nowhere"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err.find("ajar: error:"), outcome.err.rfind("ajar: error:")) << outcome.err;
}

TEST_F(MpiCli, ARankThatDiesEndsTheJobAndLeavesTheCheckpoint) {
  const pid_t job = start_ranks(2, {"render", "builtin:cornell", "--resolution", "24x16", "--time",
                                    "1h", "--progress", "json", "-o", "a.pfm", "--threads", "1",
                                    "--checkpoint", "c", "--checkpoint-every", "0.05s"});
  ASSERT_TRUE(wait_for_file(folder_ / "c")) << read_text(folder_ / ".stderr");
  // One of mpirun's children.
  const std::string children =
      read_text("/proc/" + std::to_string(job) + "/task/" + std::to_string(job) + "/children");
  const pid_t rank = std::stoi(children);
  ASSERT_GT(rank, 0);
  kill(rank, SIGKILL);
  EXPECT_NE(finish(job).exit_code, 0);
  const Outcome resumed = run({"resume", "c", "--time", "0.001s", "-o", "b.pfm"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
}

TEST_F(MpiCli, OneRankThatIsInterruptedEndsAllWithThePicture) {
  const pid_t job = start_ranks(
      2, {"render", "builtin:cornell", "--resolution", "24x16", "--time", "1h", "--progress",
          "json", "-o", "a.pfm", "--threads", "1", "--stats", "stats.json"});
  EXPECT_TRUE(wait_for(folder_ / ".stderr", "\"progress\",\"phase\":\"render\""));
  const std::string children =
      read_text("/proc/" + std::to_string(job) + "/task/" + std::to_string(job) + "/children");
  kill(std::stoi(children), SIGTERM);
  EXPECT_EQ(finish(job).exit_code, 130);
  EXPECT_TRUE(fs::exists(folder_ / "a.pfm"));
  EXPECT_EQ(statistics().at("interrupted"), true);
}

#endif

}  // namespace
}  // namespace ajar
