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

RenderOrder order_of(const SceneArguments& scene, const RunArguments& run) {
  RenderOrder order;
  order.scene = scene.scene;
  order.spec = scene.spec;
  order.default_pictures = true;
  order.ranks = run.ranks;
  order.interrupts = &interrupt_count();
  order.picture_requests = &picture_requests();
  return order;
}

void check_share(const RenderSpec& spec) {
  if (spec.share == WorkShare()) return;
  if (spec.checkpoint.empty()) {
    throw UsageError("--share needs --checkpoint: a share is of no use but for ajar merge");
  }
  if (spec.target_error) {
    throw UsageError("--share cannot go with --target-error: all shares need the same samples");
  }
}

/// Renders, and tells the user. Returns the exit code.
int carry_out(RenderOrder order, const std::string& progress) {
  const ProgressStyle style =
      order.is_root() ? progress_style(progress, isatty(STDERR_FILENO) != 0) : ProgressStyle::None;
  Console console(style, order.scene, order.resumed.has_value());
  Render render(std::move(order), console);
  const RenderOutcome& outcome = render.run();
  if (!outcome.all_written()) return kExitFile;
  return outcome.interrupted ? kExitInterrupted : 0;
}

}  // namespace

int render(const RenderArguments& a) {
  RenderOrder order = order_of(a.scene, a.run);
  RenderSpec& spec = order.spec;
  if (spec.denoise.empty()) spec.denoise = "auto";
  check_share(spec);
  lock_checkpoint_of(order);
  if (!spec.resume_from.empty() && !resume_if_there(spec.resume_from, order)) {
    print_note("there is no " + spec.resume_from + " yet: the render begins anew");
  }
  return carry_out(std::move(order), a.run.progress);
}

int resume(const ResumeArguments& a) {
  RenderOrder order = order_of(a.scene, a.run);
  resume_from(a.checkpoint, order);
  return carry_out(std::move(order), a.run.progress);
}

}  // namespace ajar::cli
