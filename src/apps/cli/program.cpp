#include "apps/cli/program.h"

#include "apps/cli/command_line.h"
#include "apps/cli/guard.h"
#include "apps/cli/several_ranks.h"
#include "os/standard_streams.h"
#include "session/job/interrupts.h"

namespace ajar::cli {

int run_program(int argc, char** argv) {
  reserve_standard_streams();
  return guard([&] {
    become_rank_if_one_of_several(argv);
    install_interrupt_handlers();
    return run(argc, argv);
  });
}

}  // namespace ajar::cli
