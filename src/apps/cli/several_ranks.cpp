#include "apps/cli/several_ranks.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "core/error.h"

namespace ajar::cli {

namespace {

/// How many processes the starter says there are: Open MPI, or a process manager of MPICH's family.
int started_processes() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    const char* const text = std::getenv(name);
    if (text != nullptr) return std::atoi(text);
  }
  return 1;
}

}  // namespace

void become_rank_if_one_of_several(char** argv) {
  const int count = started_processes();
  if (count < 2) return;
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path program = self.parent_path() / "ajar-mpi";
  execv(program.c_str(), argv);
  throw UsageError("this is one of " + std::to_string(count) +
                   " processes of mpirun, but this ajar was built without MPI (there is no " +
                   program.string() + ")");
}

}  // namespace ajar::cli
