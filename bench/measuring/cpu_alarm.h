#pragma once
#include <thread>

#include "session/job/interrupts.h"

namespace ajar::bench {

/// Interrupts a render once the process has used so many CPU-seconds more, or when the user
/// interrupts. A render's own budget is of the wall clock, by which a busy machine would cut it
/// short.
class CpuAlarm {
 public:
  CpuAlarm(double seconds, const InterruptCount& user);

  /// For `RenderJobOptions::interrupts`; lives as long as the alarm.
  const InterruptCount& interrupts() const { return interrupts_; }

 private:
  void watch(const std::stop_token& stop, double end, const InterruptCount& user);

  InterruptCount interrupts_{0};
  std::jthread thread_;
};

}  // namespace ajar::bench
