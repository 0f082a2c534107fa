#include "apps/cli/several_ranks.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace ajar::cli {

namespace {

/// Environment of the starter: Open MPI, or a process manager of MPICH's family. Nothing else runs
/// yet.
int told_by_starter(const char* open_mpi, const char* mpich, int otherwise) {
  for (const char* name : {open_mpi, mpich}) {
    const char* const text = std::getenv(name);  // NOLINT(concurrency-mt-unsafe)
    if (text != nullptr) return static_cast<int>(std::strtol(text, nullptr, 10));
  }
  return otherwise;
}

bool renders(const char* const* argv) {
  const std::string_view command = argv[1] != nullptr ? argv[1] : "";
  return command == "render" || command == "resume";
}

/// Makes this an ordinary process, and those that it starts.
void forget_starter() {
  std::vector<std::string> names;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text = *entry;
    for (const std::string_view prefix : {"OMPI_", "PMIX_", "PMI_"}) {
      if (text.starts_with(prefix)) names.emplace_back(text.substr(0, text.find('=')));
    }
  }
  for (const std::string& name : names) unsetenv(name.c_str());  // NOLINT(concurrency-mt-unsafe)
}

}  // namespace

void become_rank_if_one_of_several(char** argv) {
  const int count = told_by_starter("OMPI_COMM_WORLD_SIZE", "PMI_SIZE", 1);
  if (count < 2) return;
  if (!renders(argv)) {
    if (told_by_starter("OMPI_COMM_WORLD_RANK", "PMI_RANK", 0) > 0) _exit(0);
    forget_starter();
    return;
  }
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path program = self.parent_path() / "ajar-mpi";
  execv(program.c_str(), argv);
  throw UsageError("this is one of " + std::to_string(count) +
                   " processes of mpirun, but this ajar was built without MPI (there is no " +
                   program.string() +
                   "); with Debian: apt-get install libopenmpi-dev openmpi-bin, and build again");
}

}  // namespace ajar::cli
