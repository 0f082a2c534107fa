#pragma once
#include <chrono>
#include <cstdint>

#include "os/available_memory.h"

namespace ajar {

/// Processor time of this process so far, all threads, user and system, seconds.
double cpu_seconds();
/// CPU time of the calling thread alone.
double thread_cpu_seconds();
/// Largest resident memory of this process so far, bytes.
std::uint64_t peak_memory_bytes();
/// Wall clock that started when it was made.
class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace ajar
