#include "measuring/cpu_alarm.h"

#include <algorithm>
#include <chrono>

#include "session/job/resources.h"

namespace ajar::bench {

CpuAlarm::CpuAlarm(double seconds, const InterruptCount& user)
    : thread_([this, end = cpu_seconds() + seconds, &user](const std::stop_token& stop) {
        watch(stop, end, user);
      }) {}

void CpuAlarm::watch(const std::stop_token& stop, double end, const InterruptCount& user) {
  constexpr auto kInterval = std::chrono::milliseconds(5);
  while (!stop.stop_requested()) {
    interrupts_ = std::max(user.load(), cpu_seconds() >= end ? 1 : 0);
    std::this_thread::sleep_for(kInterval);
  }
}

}  // namespace ajar::bench
