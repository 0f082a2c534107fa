#include "study/child_process.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "core/error.h"
#include "core/testing/wait_until.h"

namespace ajar::study {
namespace {

namespace fs = std::filesystem;

class Child : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("ajar-child-" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  ChildCommand shell(const std::string& script) const {
    return {"/bin/sh", {"-c", script}, folder_.string(), (folder_ / "log").string()};
  }
  std::string log() const {
    std::ifstream file(folder_ / "log");
    std::string text;
    std::getline(file, text, '\0');
    return text;
  }
  void expect_told_of_a_signal() {
    std::thread user([&] {
      wait_until([&] { return !log().empty(); });
      interrupts_ = 1;
    });
    const ChildResult result = run_child(
        shell(
            "trap 'echo told; exit 130' INT; echo ready; for i in $(seq 400); do sleep 0.05; done"),
        interrupts_);
    user.join();
    EXPECT_EQ(result.exit_code, 130);
    EXPECT_TRUE(result.interrupted);
    EXPECT_EQ(log(), "ready\ntold\n");
  }
  fs::path folder_;
  InterruptCount interrupts_{0};
};

TEST_F(Child, RunsInItsFolderAndLogs) {
  const ChildResult result = run_child(shell("pwd; echo wrong >&2; exit 3"), interrupts_);
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_FALSE(result.interrupted);
  EXPECT_EQ(log(), fs::canonical(folder_).string() + "\nwrong\n");
}

TEST_F(Child, ReportsACrash) {
  EXPECT_EQ(run_child(shell("kill -SEGV $$"), interrupts_).exit_code, -SIGSEGV);
}

TEST_F(Child, ReceivesForwardedSignals) { expect_told_of_a_signal(); }

TEST_F(Child, ReceivesSignalsThatTheParentIgnores) {
  const auto before = std::signal(SIGINT, SIG_IGN);
  expect_told_of_a_signal();
  std::signal(SIGINT, before);
}

TEST_F(Child, ThatCannotBeStartedIsAnError) {
  EXPECT_THROW(run_child({"/no/such/program", {}, folder_.string(), (folder_ / "log").string()},
                         interrupts_),
               IoError);
}

TEST_F(Child, NothingIsWrittenThroughLinksThatAreThere) {
  std::ofstream(folder_ / "victim") << "untouched";
  fs::create_symlink("victim", folder_ / "log");
  EXPECT_EQ(run_child(shell("echo done"), interrupts_).exit_code, 0);
  EXPECT_EQ(log(), "done\n");
  EXPECT_EQ(fs::file_size(folder_ / "victim"), std::string("untouched").size());
}

}  // namespace
}  // namespace ajar::study
