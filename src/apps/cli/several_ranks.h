#pragma once

namespace ajar::cli {

/// If this process was started by mpirun as one of several that are to render, becomes `ajar-mpi`,
/// which is beside this program: MPI is a large library that starts threads and looks at networks,
/// so the program itself has nothing of it. Of commands that do not render together the root does
/// everything, as if it were alone, and the others end here. Returns if the process is alone;
/// raises UsageError if `ajar-mpi` is not there, since every process would render and write the
/// same picture.
void become_rank_if_one_of_several(char** argv);

}  // namespace ajar::cli
