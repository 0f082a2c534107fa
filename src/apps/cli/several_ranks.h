#pragma once

namespace ajar::cli {

/// If this process was started by mpirun as one of several, becomes `ajar-mpi`, which is beside
/// this program: MPI is a large library that starts threads and looks at networks, so the program
/// itself has nothing of it. Returns if the process is alone; raises UsageError if `ajar-mpi` is
/// not there, since every process would render and write the same picture.
void become_rank_if_one_of_several(char** argv);

}  // namespace ajar::cli
