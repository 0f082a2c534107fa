#include "apps/cli/command_line.h"
#include "apps/cli/guard.h"
#include "apps/cli/several_ranks.h"
#include "core/standard_streams.h"
#include "session/interrupts.h"

int main(int argc, char** argv) {
  ajar::reserve_standard_streams();
  return ajar::cli::guard([&] {
    ajar::cli::become_rank_if_one_of_several(argv);
    ajar::install_interrupt_handlers();
    return ajar::cli::run(argc, argv);
  });
}
