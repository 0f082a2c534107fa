#include <algorithm>
#include <array>
#include <chrono>
#include <thread>

#include "apps/cli/commands.h"
#include "apps/cli/exit_codes.h"
#include "apps/cli/messages.h"
#include "apps/viewer/viewer.h"
#include "core/error.h"
#include "imageio/read_picture.h"
#include "os/file_extension.h"
#include "os/standard_streams.h"
#include "session/job/interrupts.h"

namespace ajar::cli {

namespace {

bool is_loopback(const std::string& host) {
  return host == "localhost" || host == "::1" || host.starts_with("127.");
}

bool is_picture(const std::string& file) {
  constexpr std::array kExtensions = {".exr", ".pfm", ".hdr"};
  const std::string extension = file_extension(file);
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

/// Nothing that was rendered is lost.
void save_last(viewer::Viewer& viewer) {
  for (const char* format : {"exr", "png"}) {
    try {
      print_path(viewer.save(format));
    } catch (const UsageError& none) {
      print_note(none.what());
      return;
    }
  }
}

}  // namespace

int view(const ViewArguments& a) {
  if (viewer_files().empty()) {
    throw UsageError(
        "view: this program was built without its page, for which Node and npm are needed; with "
        "them, build it again");
  }
  if (!is_loopback(a.host)) {
    print_warning("--host " + a.host +
                  ": whoever reaches this machine and knows the address can see and change the "
                  "render; nothing is encrypted. ssh -L is safe (ajar view --help)");
  }
  viewer::ViewerOptions options;
  options.scene = a.scene.scene;
  if (is_picture(a.scene.scene)) {
    options.picture = std::make_shared<const Picture>(read_picture(a.scene.scene));
  }
  options.spec = a.scene.spec;
  options.host = a.host;
  options.port = static_cast<std::uint16_t>(a.port);
  options.tell = [](bool is_warning, const std::string& text) {
    if (is_warning) {
      print_warning(text);
    } else {
      print_note(text);
    }
  };
  begin_render();
  viewer::Viewer viewer(std::move(options));
  print_result(viewer.address() + "\n");
  while (interrupt_count() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  if (is_picture(a.scene.scene)) return 0;
  save_last(viewer);
  return kExitInterrupted;
}

}  // namespace ajar::cli
