#include "apps/cli/render_run.h"

#include <unistd.h>

#include <utility>

#include "apps/cli/console.h"
#include "apps/cli/exit_codes.h"
#include "session/job/interrupts.h"
#include "session/options/option_values.h"
#include "session/render.h"

namespace ajar::cli {

namespace {
RenderFiles files_of(const RunArguments& a) {
  RenderFiles files;
  files.pictures = a.outputs;
  files.default_pictures = true;
  if (!a.output_every.empty()) {
    files.pictures_every = parse_duration("--output-every", a.output_every);
  }
  files.tone_map = a.tone_map;
  files.exposure = a.exposure;
  files.denoiser = a.denoiser;
  files.checkpoint = a.checkpoint;
  files.checkpoint_every = parse_duration("--checkpoint-every", a.checkpoint_every);
  files.statistics = a.stats;
  if (!a.preview.empty()) files.preview = parse_viewer("--preview", a.preview);
  return files;
}

Budget budget_of(const RunArguments& a) {
  Budget budget;
  budget.samples_per_pixel = a.spp;
  if (!a.time.empty()) budget.seconds = parse_duration("--time", a.time);
  if (a.target_error) {
    budget.target_error = a.target_error->value;
    budget.denoised_target = a.target_error->is_denoised;
  }
  return budget;
}

}  // namespace

RenderOrder order_of(const RunArguments& a) {
  RenderOrder order;
  order.budget = budget_of(a);
  order.force = a.force;
  order.files = files_of(a);
  order.threads = a.threads;
  order.ranks = a.ranks;
  order.interrupts = &interrupt_count();
  order.picture_requests = &picture_requests();
  return order;
}

int carry_out(RenderOrder order, const std::string& progress) {
  const ProgressStyle style =
      order.is_root() ? progress_style(progress, isatty(STDERR_FILENO) != 0) : ProgressStyle::None;
  Console console(style, order.scene, order.resumed.has_value());
  Render render(std::move(order), console);
  const RenderOutcome& outcome = render.run();
  if (!outcome.all_written()) return kExitFile;
  return outcome.interrupted ? kExitInterrupted : 0;
}

}  // namespace ajar::cli
