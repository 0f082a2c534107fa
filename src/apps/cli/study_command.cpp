#include <filesystem>

#include "apps/cli/commands.h"
#include "apps/cli/exit_codes.h"
#include "apps/cli/messages.h"
#include "core/error.h"
#include "os/file_lock.h"
#include "session/job/interrupts.h"
#include "study/child_process.h"
#include "study/study_output.h"
#include "study/study_runner.h"

namespace ajar::cli {

namespace {
namespace fs = std::filesystem;

fs::path make_folder(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error || !fs::is_directory(path)) {
    throw IoError(path + ": cannot make this folder: " + error.message());
  }
  return fs::absolute(path).lexically_normal();
}
}  // namespace

int study(const StudyArguments& arguments) {
  const study::StudyPlan plan = study::read_study(arguments.file);
  for (const std::string& scene : plan.left_out) print_warning(scene);
  study::StudyOptions options;
  options.folder = fs::absolute(arguments.file).parent_path();
  options.out =
      make_folder(arguments.out.empty() ? fs::path(arguments.file).stem().string() + "-results"
                                        : arguments.out);
  const FileLock lock(options.out / ".lock",
                      options.out.string() + ": another study is writing here");
  options.program = study::kOwnProgram;
  options.report = print_note;
  // From here on a signal ends the render that runs, and what is finished is kept.
  begin_render();
  const study::StudyResult result = study::run_study(plan, options);
  for (const std::string& warning : result.warnings) print_warning(warning);
  for (const std::string& failure : result.failures) print_error(failure);
  for (const std::string& path : study::write_study(plan, result, options.out)) {
    print_path(path);
  }
  if (result.interrupted) {
    print_note("interrupted; the same command goes on where it stopped");
    return kExitInterrupted;
  }
  return result.failures.empty() ? 0 : kExitFailedRuns;
}

}  // namespace ajar::cli
