#include "study/child_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>
#include <thread>

#include "core/error.h"

namespace ajar::study {

namespace {
/// Interval of the parent's polls: costs nothing beside a render.
constexpr auto kPoll = std::chrono::milliseconds(10);
constexpr int kNotStarted = 127;

/// In the child, after fork: async-signal-safe calls only. Never returns.
[[noreturn]] void become(const ChildCommand& command, char* const* argv, pid_t parent, int log) {
  setpgid(0, 0);
  // Killed and not asked: it must not write files that a later run of the same name has written.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kNotStarted);
  // A script's background jobs ignore it, and so would their children. One that was passed on since
  // the fork has waited, and now ends the child.
  signal(SIGINT, SIG_DFL);
  sigset_t interrupt;
  sigemptyset(&interrupt);
  sigaddset(&interrupt, SIGINT);
  sigprocmask(SIG_UNBLOCK, &interrupt, nullptr);
  if (chdir(command.folder.c_str()) != 0) _exit(kNotStarted);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  execv(command.program.c_str(), argv);
  _exit(kNotStarted);
}

/// Always a new file: through a link that is there something else would be overwritten.
int new_log(const std::string& path) {
  unlink(path.c_str());
  const int log = open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
  if (log < 0) {
    throw IoError("cannot write \"" + path + "\": " + std::system_category().message(errno));
  }
  return log;
}
}  // namespace

ChildResult run_child(const ChildCommand& command, const InterruptCount& interrupts) {
  std::vector<char*> argv{const_cast<char*>(command.program.c_str())};
  for (const std::string& argument : command.arguments) {
    argv.push_back(const_cast<char*>(argument.c_str()));
  }
  argv.push_back(nullptr);
  int passed_on = 0;
  const pid_t parent = getpid();
  const int log = new_log(command.log);
  // Between fork and exec the child has this program's handler, which would only count in vain.
  sigset_t interrupt;
  sigset_t before;
  sigemptyset(&interrupt);
  sigaddset(&interrupt, SIGINT);
  pthread_sigmask(SIG_BLOCK, &interrupt, &before);
  const pid_t child = fork();
  if (child == 0) become(command, argv.data(), parent, log);
  const int reason = errno;
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  close(log);
  if (child < 0) {
    throw IoError("cannot start a process: " + std::system_category().message(reason));
  }
  ChildResult result;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    for (; passed_on < interrupts.load(); ++passed_on) kill(child, SIGINT);
    std::this_thread::sleep_for(kPoll);
  }
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  result.interrupted = interrupts.load() > 0;
  if (result.exit_code == kNotStarted) {
    throw IoError("cannot run " + command.program + " in " + command.folder + ", log " +
                  command.log);
  }
  return result;
}

}  // namespace ajar::study
