#include "session/job/pass_queue.h"

#include <exception>
#include <utility>

namespace ajar {

bool PassQueue::ask(Look look) {
  std::future<bool> answer;
  {
    const std::lock_guard lock(mutex_);
    if (!open_ || std::this_thread::get_id() == renders_) return false;
    asked_.push_back({std::move(look), {}});
    answer = asked_.back().answer.get_future();
  }
  return answer.get();
}

void PassQueue::open() {
  const std::lock_guard lock(mutex_);
  open_ = true;
  renders_ = std::this_thread::get_id();
}

void PassQueue::close(const Film& film, const JobState& state) {
  {
    const std::lock_guard lock(mutex_);
    open_ = false;
  }
  see_picture(film, state);
}

void PassQueue::close() {
  {
    const std::lock_guard lock(mutex_);
    open_ = false;
  }
  for (Asked& asked : take_all()) asked.answer.set_value(false);
}

bool PassQueue::wants_picture(const JobState& /*state*/) {
  const std::lock_guard lock(mutex_);
  return !asked_.empty();
}

void PassQueue::see_picture(const Film& film, const JobState& state) {
  for (Asked& asked : take_all()) {
    try {
      asked.look(film, state);
      asked.answer.set_value(true);
    } catch (...) {
      asked.answer.set_exception(std::current_exception());
    }
  }
}

std::deque<PassQueue::Asked> PassQueue::take_all() {
  const std::lock_guard lock(mutex_);
  return std::exchange(asked_, {});
}

}  // namespace ajar
