#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "session/checkpoint/checkpoint_writer.h"
#include "session/output/picture_writer.h"
#include "session/preview/preview.h"
#include "session/render/render_events.h"
#include "session/render/render_outcome.h"
#include "session/render/render_request.h"

namespace ajar {

/// The files of a render, written while it runs and in the end, and its viewer.
class RenderWriters {
 public:
  /// `base`: of the checkpoints; empty: none are written. `preview`: may be null. Tells `events`
  /// what goes wrong. All that is referred to must outlive this.
  RenderWriters(const RenderRequest& request, const Integrator& integrator,
                std::optional<Checkpoint> base, std::unique_ptr<Preview> preview,
                PictureWriter::Develop develop, RenderEvents& events);

  /// To be told of each pass.
  std::vector<PassObserver*> observers() const;

  /// The last picture, to the viewer.
  void show_last(const RenderJob& job);
  /// The last files: those of `outcome.picture` and, if `with_checkpoint`, the checkpoint before
  /// them, since the picture of a finished render may be wanted where that cannot be written. Where
  /// there is no room it waits for as long as nobody adds to `interrupts`. Completes `outcome` with
  /// what was written.
  void write_last(const RenderJob& job, bool with_checkpoint, const InterruptCount& interrupts,
                  RenderOutcome& outcome);

 private:
  const RenderSpec& spec_;
  RenderEvents& events_;
  std::unique_ptr<CheckpointWriter> checkpoint_;
  std::unique_ptr<PictureWriter> pictures_;
  std::unique_ptr<Preview> preview_;
};

/// Why they could not be written; empty if they could, or `path` is.
std::string write_statistics(const RenderStatistics& statistics, const std::string& path);

}  // namespace ajar
