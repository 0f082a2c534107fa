#include "core/warnings.h"

namespace ajar {

void Warnings::add(const SourceLocation& where, const std::string& message) {
  add(located(where, message));
}

void Warnings::add(const std::string& message) {
  const std::lock_guard lock(mutex_);
  ++count_;
  if (messages_.size() < kMaxKept) messages_.push_back(message);
}

std::size_t Warnings::count() const {
  const std::lock_guard lock(mutex_);
  return count_;
}

std::vector<std::string> Warnings::messages() const {
  const std::lock_guard lock(mutex_);
  return messages_;
}

}  // namespace ajar
