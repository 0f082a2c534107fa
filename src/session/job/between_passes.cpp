#include "session/job/between_passes.h"

#include <exception>
#include <utility>

namespace ajar {

bool BetweenPasses::ask(Look look) {
  std::future<bool> answer;
  {
    const std::lock_guard lock(mutex_);
    if (!open_ || std::this_thread::get_id() == renders_) return false;
    asked_.push_back({std::move(look), {}});
    answer = asked_.back().answer.get_future();
  }
  return answer.get();
}

void BetweenPasses::open() {
  const std::lock_guard lock(mutex_);
  open_ = true;
  renders_ = std::this_thread::get_id();
}

void BetweenPasses::close(const Film& film, const JobState& state) {
  {
    const std::lock_guard lock(mutex_);
    open_ = false;
  }
  see_picture(film, state);
}

void BetweenPasses::close() {
  {
    const std::lock_guard lock(mutex_);
    open_ = false;
  }
  for (Asked& asked : take_all()) asked.answer.set_value(false);
}

bool BetweenPasses::wants_picture(const JobState& /*state*/) {
  const std::lock_guard lock(mutex_);
  return !asked_.empty();
}

void BetweenPasses::see_picture(const Film& film, const JobState& state) {
  for (Asked& asked : take_all()) {
    try {
      asked.look(film, state);
      asked.answer.set_value(true);
    } catch (...) {
      asked.answer.set_exception(std::current_exception());
    }
  }
}

std::deque<BetweenPasses::Asked> BetweenPasses::take_all() {
  const std::lock_guard lock(mutex_);
  return std::exchange(asked_, {});
}

}  // namespace ajar
