#include "session/output/repeated_writing.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "session/heuristics.h"

namespace ajar {

RepeatedWriting::RepeatedWriting(std::string what, double every, Say warn, Say note)
    : what_(std::move(what)),
      every_(every),
      warn_(std::move(warn)),
      note_(std::move(note)),
      due_(every) {}

bool RepeatedWriting::attempt(const std::function<void()>& write) {
  const double begun = clock_.seconds();
  std::string failure;
  try {
    write();
  } catch (const std::exception& error) {
    failure = error.what();
  }
  seconds_ = clock_.seconds() - begun;
  const double pause = failure.empty() ? every_ : std::min(every_, SessionHeuristics::kUntilRetry);
  due_ = clock_.seconds() + std::max(pause, seconds_ / SessionHeuristics::kMostForWriting);
  if (!failure.empty() && failure != failure_) {
    warn_(failure + "; " + what_ + " will be tried again, the render goes on");
  }
  if (failure.empty() && !failure_.empty()) note_(what_ + " could be written again");
  failure_ = failure;
  return failure.empty();
}

}  // namespace ajar
