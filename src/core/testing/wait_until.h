#pragma once
#include <chrono>
#include <thread>

namespace ajar {

/// For tests of other threads and processes: returns true as soon as `condition()` is true, false
/// after a minute. The limit is generous, since the machine may be busy.
template <typename Condition>
bool wait_until(const Condition& condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (std::chrono::steady_clock::now() < end) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return condition();
}

}  // namespace ajar
