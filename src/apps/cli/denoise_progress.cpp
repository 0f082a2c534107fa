#include "apps/cli/denoise_progress.h"

#include <unistd.h>

#include <atomic>

#include "apps/cli/progress_reporter.h"
#include "session/job/interrupts.h"
#include "session/job/resources.h"

namespace ajar::cli {

bool denoise_with_progress(const std::function<bool(const Denoiser::Progress& progress)>& filter) {
  // From here on signals are counted, and end nothing at once.
  begin_render();
  const Stopwatch clock;
  std::atomic<double> fraction{0.0};
  const ProgressReporter reporter(progress_style("auto", isatty(STDERR_FILENO) != 0), [&] {
    RenderSnapshot snapshot;
    snapshot.phase = RenderPhase::Denoise;
    snapshot.phase_done = fraction;
    snapshot.seconds = clock.seconds();
    return snapshot;
  });
  return filter([&](double done) {
    fraction = done;
    return interrupt_count() == 0;
  });
}

}  // namespace ajar::cli
