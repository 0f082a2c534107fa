#pragma once
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "core/testing/wait_until.h"

/// Fixture of tests of the program.
namespace ajar {

namespace fs = std::filesystem;
using nlohmann::json;

inline std::string read_text(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

struct Outcome {
  int exit_code = -1;  ///< negative: ended by that signal
  std::string out, err;
};

/// Runs the program in a folder of its own that is gone after the test.
class Cli : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / ("ajar-cli-" + std::string(test->test_suite_name()) +
                                           "-" + test->name() + "-" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override {
    fs::permissions(folder_, fs::perms::owner_all);
    fs::remove_all(folder_);
  }

  /// `change`: called in the new process before it becomes the program.
  pid_t start(const std::vector<std::string>& arguments, const std::string& program = AJAR_PROGRAM,
              const std::function<void()>& change = {}) const {
    const pid_t child = fork();
    if (child != 0) return child;
    const auto redirect = [&](const char* name, int target) {
      const std::string path = (folder_ / name).string();
      dup2(open(path.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600), target);
    };
    if (chdir(folder_.c_str()) != 0) _exit(99);
    // Parents may ignore them, with nohup or in the background of a script.
    for (const int signal : {SIGHUP, SIGINT}) ::signal(signal, SIG_DFL);
    redirect(".stdout", STDOUT_FILENO);
    redirect(".stderr", STDERR_FILENO);
    if (change) change();
    std::vector<char*> argv{const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments) {
      argv.push_back(const_cast<char*>(argument.c_str()));
    }
    argv.push_back(nullptr);
    execv(program.c_str(), argv.data());
    _exit(98);
  }

  Outcome finish(pid_t child) const {
    int status = 0;
    waitpid(child, &status, 0);
    Outcome outcome;
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    outcome.out = read_text(folder_ / ".stdout");
    outcome.err = read_text(folder_ / ".stderr");
    return outcome;
  }

  Outcome run(const std::vector<std::string>& arguments) const { return finish(start(arguments)); }

  /// `ajar render builtin:cornell` as small as it can be, with more arguments.
  Outcome render(std::vector<std::string> more) const {
    std::vector<std::string> arguments{"render", "builtin:cornell", "--resolution",
                                       "24x16",  "--progress",      "none"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  fs::path file(const std::string& name, const std::string& text = {}) const {
    if (!text.empty()) std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }

  /// Names of all.
  std::vector<std::string> integrators() const {
    std::vector<std::string> names;
    const json list = json::parse(run({"list", "--json"}).out);
    for (const json& entry : list.at("integrators")) {
      names.push_back(entry.at("name"));
    }
    return names;
  }
  json statistics(const std::string& name = "stats.json") const {
    return json::parse(read_text(folder_ / name));
  }

  fs::path folder_;
};

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Waits until the program has written `part` to stderr; false if it does not, see `wait_until`.
inline bool wait_for(const fs::path& log, const std::string& part) {
  return wait_until([&] { return contains(read_text(log), part); });
}

inline bool wait_for_file(const fs::path& file) {
  return wait_until([&] { return fs::exists(file); });
}

}  // namespace ajar
