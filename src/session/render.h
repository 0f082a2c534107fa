#pragma once
#include <memory>
#include <optional>

#include "session/render/render_events.h"
#include "session/render/render_outcome.h"
#include "session/render/render_request.h"

namespace ajar {

/// A render from its scene to its picture: loads, chooses the method, builds, prepares, renders
/// pass after pass, writes files if there are to be any.
///
///     RenderRequest order;
///     order.scene = "builtin:cornell";
///     order.request.emplace().budget.seconds = 10.0;
///     Render render(std::move(order));
///     const RenderOutcome& outcome = render.run();
///
/// Needs no terminal, prints nothing and handles no signals; its messages go to `RenderEvents`.
/// Several may run at once, except that a number of threads, if one is given, limits the whole
/// process while a render lives (a limit of TBB, which Embree needs, too).
class Render {
 public:
  /// `events` must outlive this. Raises, before anything is loaded, UsageError for orders that
  /// cannot be carried out and IoError for files that cannot be written.
  explicit Render(RenderRequest request);
  Render(RenderRequest request, RenderEvents& events);
  ~Render();
  Render(const Render&) = delete;
  Render& operator=(const Render&) = delete;

  /// Renders on this thread and on those of TBB until the budget is used up or someone stops it;
  /// to be called once. Raises UsageError, SceneError and IoError.
  const RenderOutcome& run();

  // At any time, from any thread.

  /// Finishes the pass that runs, and ends; called twice, the pass is cut short. Before there are
  /// passes it cuts the preparation short; twice, nothing is rendered.
  void stop();
  /// Progress.
  RenderSnapshot snapshot() const;
  /// The picture as it is, all layers: waits for the end of the pass that runs. Before there are
  /// passes, what the preparation has seen, without other layers and of 0 samples per pixel; null
  /// before that, and among passes on the thread that renders, which has `RenderEvents::picture`.
  std::shared_ptr<const Picture> picture();
  /// All that is known: waits likewise, except where there would be no picture.
  RenderStatistics statistics();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace ajar
