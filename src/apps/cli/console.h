#pragma once
#include <optional>
#include <string>

#include "apps/cli/progress_reporter.h"
#include "session/render/render_events.h"

namespace ajar::cli {

/// Tells people at a terminal, and programs that read its lines, what a render tells.
class Console final : public RenderEvents {
 public:
  /// `resumes`: it goes on from a checkpoint, which is all there is to lose until it does.
  Console(ProgressStyle style, std::string scene, bool resumes);

  void phase_begun(RenderPhase phase) override;
  void work_begun(const std::function<RenderSnapshot()>& snapshot) override;
  void work_ended() noexcept override;
  void scene_warnings(const Warnings& warnings) override;
  void warning(const Warning& warning) override;
  void trouble(const std::string& text) override;
  void note(const std::string& text) override;
  void finished(const RenderOutcome& outcome) override;

 private:
  ProgressStyle style_;
  std::string scene_;
  bool resumes_;
  std::optional<ProgressReporter> reporter_;
};

}  // namespace ajar::cli
