#pragma once
#include <functional>
#include <string>

#include "session/job/resources.h"

namespace ajar {

/// When something is written again and again while a render runs, and what is said if that fails:
/// each reason once, and when it works again. A failure is no reason to stop; it is tried again.
class RepeatedWriting {
 public:
  using Say = std::function<void(const std::string&)>;

  /// `what`: for messages, such as "the checkpoint". `every`: seconds; infinite for never. `warn`
  /// and `note` tell the user.
  RepeatedWriting(std::string what, double every, Say warn, Say note);

  /// True if it is due. Slow writing is done less often, so that most of the time is left for
  /// rendering.
  bool is_due() const { return clock_.seconds() >= due_; }
  /// Writes; what `write` raises is told. True if it raised nothing.
  bool attempt(const std::function<void()>& write);
  /// Duration of the latest attempt; 0 before the first.
  double seconds() const { return seconds_; }

 private:
  std::string what_;
  double every_;
  Say warn_;
  Say note_;
  Stopwatch clock_;
  double due_;
  double seconds_ = 0.0;
  std::string failure_;  // the latest; empty if the latest attempt succeeded
};

}  // namespace ajar
