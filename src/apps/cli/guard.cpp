#include "apps/cli/guard.h"

#include <exception>
#include <filesystem>
#include <new>
#include <string>

#include "apps/cli/exit_codes.h"
#include "apps/cli/messages.h"
#include "core/error.h"

namespace ajar::cli {

namespace {
int run_guarded(const std::function<int()>& command, bool& raised) {
  raised = true;
  try {
    const int code = command();
    raised = false;
    return code;
  } catch (const Error& error) {
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
}  // namespace

int guard(const std::function<int()>& command, const std::function<void(int)>& after_error) {
  bool raised = false;
  const int code = run_guarded(command, raised);
  if (raised && after_error) after_error(code);
  return code;
}

}  // namespace ajar::cli
