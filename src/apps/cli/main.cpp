#include <exception>
#include <filesystem>
#include <new>
#include <stdexcept>

#include "apps/cli/command_line.h"
#include "apps/cli/messages.h"
#include "core/error.h"
#include "session/interrupts.h"

namespace {

constexpr int kExitScene = 3;
constexpr int kExitFile = 4;

}  // namespace

int main(int argc, char** argv) {
  using ajar::cli::print_error;
  try {
    ajar::install_interrupt_handlers();
    return ajar::cli::run(argc, argv);
  } catch (const ajar::Error& error) {
    print_error(error.what());
    return error.exit_code();
  } catch (const std::bad_alloc&) {
    print_error("not enough memory for this scene and picture; try a smaller --resolution");
    return kExitScene;
  } catch (const std::filesystem::filesystem_error& error) {
    print_error(error.what());
    return kExitFile;
  } catch (const std::exception& error) {
    print_error(std::string("internal error: ") + error.what() + " (please report this)");
    return kExitScene;
  }
}
