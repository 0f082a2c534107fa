#include "session/render/render_watch.h"

#include <utility>

namespace ajar {

void RenderWatch::follow(std::function<RenderSnapshot()> source) {
  const std::lock_guard lock(mutex_);
  source_ = std::move(source);
}

void RenderWatch::unfollow() {
  const std::lock_guard lock(mutex_);
  if (!source_) return;
  latest_ = source_();
  source_ = {};
}

void RenderWatch::know(const RenderStatistics& statistics) {
  const std::lock_guard lock(mutex_);
  statistics_ = statistics;
}

void RenderWatch::know(std::shared_ptr<const Picture> last_picture) {
  const std::lock_guard lock(mutex_);
  last_picture_ = std::move(last_picture);
}

RenderSnapshot RenderWatch::snapshot() const {
  const std::lock_guard lock(mutex_);
  return source_ ? source_() : latest_;
}

RenderStatistics RenderWatch::statistics() const {
  const std::lock_guard lock(mutex_);
  return statistics_;
}

std::shared_ptr<const Picture> RenderWatch::last_picture() const {
  const std::lock_guard lock(mutex_);
  return last_picture_;
}

}  // namespace ajar
