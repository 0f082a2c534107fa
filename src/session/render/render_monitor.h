#pragma once
#include <functional>
#include <memory>
#include <mutex>

#include "imageio/picture.h"
#include "session/job/pass_queue.h"
#include "session/job/render_job.h"
#include "session/output/stats_json.h"

namespace ajar {

/// Where a render stands, told by the thread that renders, for any thread to see.
class RenderMonitor {
 public:
  /// Passes may be looked at, too.
  PassQueue passes;

  /// From here on `snapshot` asks `source`, which must live until `unfollow`; then its last answer
  /// stays.
  void attach(std::function<RenderSnapshot()> source);
  void detach();
  void publish(const RenderStatistics& statistics);
  void publish(std::shared_ptr<const Picture> last_picture);

  RenderSnapshot snapshot() const;
  /// The latest that is known, without what passes have found since.
  RenderStatistics statistics() const;
  /// Picture of a finished render; before its passes, the preview of the preparation, if any; else
  /// null.
  std::shared_ptr<const Picture> last_picture() const;

 private:
  mutable std::mutex mutex_;  // guards all below
  std::function<RenderSnapshot()> source_;
  RenderSnapshot latest_;
  RenderStatistics statistics_;
  std::shared_ptr<const Picture> last_picture_;
};

}  // namespace ajar
