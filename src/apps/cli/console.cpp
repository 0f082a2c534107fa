#include "apps/cli/console.h"

#include <utility>

#include "apps/cli/messages.h"
#include "apps/cli/render_report.h"
#include "session/job/interrupts.h"
#include "session/render/render_outcome.h"

namespace ajar::cli {

Console::Console(ProgressStyle style, std::string scene, bool resumes)
    : style_(style), scene_(std::move(scene)), resumes_(resumes) {}

void Console::phase_begun(RenderPhase phase) {
  // Before there is anything to lose signals end the program at once.
  if (phase == RenderPhase::Render || (phase == RenderPhase::Prepare && !resumes_)) begin_render();
  report_phase(style_, to_string(phase));
}

void Console::work_begun(const std::function<RenderSnapshot()>& snapshot) {
  reporter_.emplace(style_, snapshot);
}

void Console::work_ended() noexcept { reporter_.reset(); }

void Console::scene_warnings(const Warnings& warnings) { print_warnings(warnings, scene_); }
void Console::warning(const Warning& warning) { print_warning(warning.text()); }
void Console::trouble(const std::string& text) { print_warning(text); }
void Console::note(const std::string& text) { print_note(text); }

void Console::finished(const RenderOutcome& outcome) {
  if (!outcome.picture) return;
  const RenderStatistics& statistics = outcome.statistics;
  if (!outcome.statistics_error.empty()) print_error(outcome.statistics_error);
  print_note(end_text(statistics.result, statistics.times.prepare, statistics.denoised_error));
  std::vector<std::string> pictures;
  for (const WrittenFile& file : outcome.files) pictures.push_back(file.wanted);
  report_exposure(*outcome.picture, pictures, outcome.display, statistics.exposure.automatic);
  for (const WrittenFile& file : outcome.files) report_file(file);
  for (const std::string& path : statistics.outputs) print_path(path);
}

}  // namespace ajar::cli
