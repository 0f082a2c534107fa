#include "session/render/render_monitor.h"

#include <utility>

namespace ajar {

void RenderMonitor::attach(std::function<RenderSnapshot()> source) {
  const std::lock_guard lock(mutex_);
  source_ = std::move(source);
}

void RenderMonitor::detach() {
  const std::lock_guard lock(mutex_);
  if (!source_) return;
  latest_ = source_();
  source_ = {};
}

void RenderMonitor::publish(const RenderStatistics& statistics) {
  const std::lock_guard lock(mutex_);
  statistics_ = statistics;
}

void RenderMonitor::publish(std::shared_ptr<const Picture> last_picture) {
  const std::lock_guard lock(mutex_);
  last_picture_ = std::move(last_picture);
}

RenderSnapshot RenderMonitor::snapshot() const {
  const std::lock_guard lock(mutex_);
  return source_ ? source_() : latest_;
}

RenderStatistics RenderMonitor::statistics() const {
  const std::lock_guard lock(mutex_);
  return statistics_;
}

std::shared_ptr<const Picture> RenderMonitor::last_picture() const {
  const std::lock_guard lock(mutex_);
  return last_picture_;
}

}  // namespace ajar
