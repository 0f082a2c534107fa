#pragma once

#if defined(__SANITIZE_THREAD__)
#define AJAR_THREAD_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define AJAR_THREAD_SANITIZER 1
#endif
#endif
#ifdef AJAR_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace ajar {

/// Tells ThreadSanitizer in which order oneTBB puts a loop and its tasks: what came before the loop
/// happens before every task, and every task before what follows the loop. oneTBB's library is not
/// compiled with the sanitizer, which would otherwise report each result that a task leaves behind
/// as a race. Lives as long as the loop; does nothing in other builds.
class ForkJoin {
 public:
  ForkJoin() { release(&forked_); }
  ~ForkJoin() { acquire(&joined_); }
  ForkJoin(const ForkJoin&) = delete;
  ForkJoin& operator=(const ForkJoin&) = delete;

  /// Lives as long as one task of the loop.
  class Task {
   public:
    explicit Task(ForkJoin& loop) : loop_(loop) { acquire(&loop.forked_); }
    ~Task() { release(&loop_.joined_); }
    Task(const Task&) = delete;
    Task& operator=(const Task&) = delete;

   private:
    ForkJoin& loop_;
  };

 private:
#ifdef AJAR_THREAD_SANITIZER
  static void acquire(char* event) { __tsan_acquire(event); }
  static void release(char* event) { __tsan_release(event); }
#else
  static void acquire(char* /*event*/) {}
  static void release(char* /*event*/) {}
#endif

  // Only their addresses matter.
  char forked_ = 0;
  char joined_ = 0;
};

}  // namespace ajar
