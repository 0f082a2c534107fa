// Writes the example report and lets scripts use it in headless browsers.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "report/example_content.h"
#include "study/report/report.h"

namespace ajar {
namespace {

namespace fs = std::filesystem;

constexpr int kNoBrowser = 77;  // as the script returns it

struct Outcome {
  int exit_code = 0;
  std::string output;
};

Outcome run(const std::string& command) {
  Outcome outcome;
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return {-1, "cannot start a shell"};
  std::array<char, 4096> part{};
  for (std::size_t n = 0; (n = std::fread(part.data(), 1, part.size(), pipe)) > 0;) {
    outcome.output.append(part.data(), n);
  }
  const int status = pclose(pipe);
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

/// Skips without the browser or Python.
void drive(const char* script) {
  if (run("python3 --version").exit_code != 0) GTEST_SKIP() << "python3 is not installed";
  const fs::path folder = fs::temp_directory_path() / ("ajar-page-" + std::to_string(getpid()));
  write_report(example_report(), folder);
  const Outcome outcome = run(std::string("python3 \"" AJAR_PAGE_DRIVERS "/") + script + "\" \"" +
                              folder.string() + "\"");
  fs::remove_all(folder);
  if (outcome.exit_code == kNoBrowser) GTEST_SKIP() << outcome.output;
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
}

TEST(ReportPage, WorksInChromium) { drive("drive_page.py"); }

TEST(ReportPage, WorksInFirefox) { drive("drive_firefox.py"); }

}  // namespace
}  // namespace ajar
