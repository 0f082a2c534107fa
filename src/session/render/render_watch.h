#pragma once
#include <functional>
#include <memory>
#include <mutex>

#include "imageio/picture.h"
#include "session/job/between_passes.h"
#include "session/job/render_job.h"
#include "session/output/stats_json.h"

namespace ajar {

/// Where a render stands, told by the thread that renders, for any thread to see.
class RenderWatch {
 public:
  /// Passes may be looked at, too.
  BetweenPasses passes;

  /// From here on `snapshot` asks `source`, which must live until `unfollow`; then its last answer
  /// stays.
  void follow(std::function<RenderSnapshot()> source);
  void unfollow();
  void know(const RenderStatistics& statistics);
  void know(std::shared_ptr<const Picture> last_picture);

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
