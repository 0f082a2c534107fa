#pragma once
#include "image/film.h"
#include "session/job/job_state.h"

namespace ajar {

/// Observer of a picture while it is rendered: checkpoints, files, viewers. Called between passes,
/// on the thread that renders; while it runs nothing is rendered.
class PassObserver {
 public:
  virtual ~PassObserver() = default;
  /// True if the picture is needed after this pass. Asked after each; must be quick.
  virtual bool wants_picture(const JobState& state) = 0;
  /// The whole picture, as far as it is. Raises nothing: what goes wrong is no reason to stop.
  virtual void see_picture(const Film& film, const JobState& state) = 0;
};

}  // namespace ajar
