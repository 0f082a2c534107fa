#pragma once
#include <functional>
#include <string>

#include "core/warnings.h"
#include "imageio/picture.h"
#include "session/job/render_job.h"

namespace ajar {

struct RenderOutcome;

/// Events of a render, on the thread that runs it; notes of a viewer come from another thread. An
/// exception of a listener ends the render, as an error of its own would; but one of `picture` is
/// reported as trouble.
class RenderEvents {
 public:
  virtual ~RenderEvents() = default;
  virtual void phase_begun(RenderPhase /*phase*/) {}
  /// Around what takes long, preparing and rendering, also where it raises an error. `snapshot`
  /// tells how far it is, and may be called by any thread in between.
  virtual void work_begun(const std::function<RenderSnapshot()>& /*snapshot*/) {}
  virtual void work_ended() noexcept {}
  /// After each pass.
  virtual void progress(const RenderSnapshot& /*snapshot*/) {}
  /// The picture as it is, every `RenderRequest::show_every` seconds; at first, unless these are
  /// infinite, what the preparation has seen.
  virtual void picture(const Picture& /*picture*/) {}
  /// Asked after each pass, and when the preparation has seen something: true if `picture` is
  /// wanted, however soon after the last.
  virtual bool wants_picture() { return false; }

  /// Once the scene is built: what is unusual in it, all together.
  virtual void scene_warnings(const Warnings& /*warnings*/) {}
  /// A warning after the start.
  virtual void warning(const Warning& /*warning*/) {}
  /// A file that cannot be written now, and will be tried again: no warning about the picture.
  virtual void trouble(const std::string& /*text*/) {}
  /// A remark for the user, one sentence.
  virtual void note(const std::string& /*text*/) {}

  /// The end, unless an error is raised.
  virtual void finished(const RenderOutcome& /*outcome*/) {}
};

}  // namespace ajar
