// `ajar` as one of several processes of mpirun that render together; the root writes the result.
#include <mpi.h>

#include <chrono>
#include <thread>

#include "apps/cli/command_line.h"
#include "apps/cli/guard.h"
#include "apps/cli/messages.h"
#include "apps/mpi/mpi_ranks.h"
#include "os/standard_streams.h"
#include "session/job/interrupts.h"

namespace {

int run(int argc, char** argv) {
  ajar::MpiRanks ranks;
  if (!ranks.is_root()) ajar::cli::print_errors_only();
  // After an error the others would wait for this process forever. What is wrong for all is told by
  // the root, which ends the others meanwhile; what is wrong for one of them is told a little
  // later.
  const auto end_all = [](int code) { MPI_Abort(MPI_COMM_WORLD, code); };
  return ajar::cli::guard(
      [&] {
        try {
          return ajar::cli::run(argc, argv, &ranks);
        } catch (...) {
          if (!ranks.is_root()) std::this_thread::sleep_for(std::chrono::seconds(10));
          throw;
        }
      },
      end_all);
}

}  // namespace

int main(int argc, char** argv) {
  ajar::reserve_standard_streams();
  // Only the thread that calls RenderJob::run talks to the others.
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  // After MPI, which has handlers of its own.
  ajar::install_interrupt_handlers();
  const int code = run(argc, argv);
  MPI_Finalize();
  return code;
}
