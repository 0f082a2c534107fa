#pragma once
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <thread>

#include "session/job/pass_observer.h"

namespace ajar {

/// Lets other threads look at a render: what they ask is answered between passes, on the thread
/// that renders, which nothing disturbs meanwhile.
class PassQueue final : public PassObserver {
 public:
  using Look = std::function<void(const Film& film, const JobState& state)>;

  /// Waits until `look` has been called, at the end of the first pass at the earliest; what it
  /// raises is raised here. False if it was not called, since no passes run: not yet, or not any
  /// more. False, too, at once, on the thread that renders, which would wait for itself.
  bool ask(Look look);

  /// From here on passes run, on this thread.
  void open();
  /// The passes are over: waiting threads still see the final picture.
  void close(const Film& film, const JobState& state);
  /// The passes failed. May be called more than once, and after `close`.
  void close();

  bool wants_picture(const JobState& state) override;
  void see_picture(const Film& film, const JobState& state) override;

 private:
  struct Asked {
    Look look;
    std::promise<bool> answer;
  };
  std::deque<Asked> take_all();

  std::mutex mutex_;  // guards all below
  bool open_ = false;
  std::thread::id renders_;
  std::deque<Asked> asked_;
};

}  // namespace ajar
