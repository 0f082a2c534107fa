#include <unistd.h>

#include <utility>

#include "apps/cli/commands.h"
#include "apps/cli/console.h"
#include "apps/cli/exit_codes.h"
#include "apps/cli/messages.h"
#include "core/error.h"
#include "session/job/interrupts.h"
#include "session/render.h"

namespace ajar::cli {

namespace {

RenderRequest order_of(const SceneArguments& scene, const RunArguments& run) {
  RenderRequest request;
  request.scene = scene.scene;
  request.spec = scene.spec;
  request.default_pictures = true;
  request.ranks = run.ranks;
  request.interrupts = &interrupt_count();
  request.picture_requests = &picture_requests();
  return request;
}

void check_share(const RenderSpec& spec) {
  if (spec.share == WorkSlice()) return;
  if (spec.checkpoint.empty()) {
    throw UsageError("--share needs --checkpoint: a share is of no use but for ajar merge");
  }
  if (spec.target_error) {
    throw UsageError("--share cannot go with --target-error: all shares need the same samples");
  }
}

/// Renders, and tells the user. Returns the exit code.
int carry_out(RenderRequest request, const std::string& progress) {
  const ProgressStyle style = request.is_root()
                                  ? progress_style(progress, isatty(STDERR_FILENO) != 0)
                                  : ProgressStyle::None;
  Console console(style, request.scene, request.resumed.has_value());
  Render render(std::move(request), console);
  const RenderOutcome& outcome = render.run();
  if (!outcome.all_written()) return kExitFile;
  return outcome.interrupted ? kExitInterrupted : 0;
}

}  // namespace

int render(const RenderArguments& a) {
  RenderRequest request = order_of(a.scene, a.run);
  RenderSpec& spec = request.spec;
  if (spec.denoise.empty()) spec.denoise = "auto";
  check_share(spec);
  lock_checkpoint_of(request);
  if (!spec.resume_from.empty() && !resume_if_there(spec.resume_from, request)) {
    print_note("there is no " + spec.resume_from + " yet: the render begins anew");
  }
  return carry_out(std::move(request), a.run.progress);
}

int resume(const ResumeArguments& a) {
  RenderRequest request = order_of(a.scene, a.run);
  resume_from(a.checkpoint, request);
  return carry_out(std::move(request), a.run.progress);
}

}  // namespace ajar::cli
