#pragma once
#include <chrono>
#include <cstdint>

namespace ajar {

/// Processor time of this process so far, all threads, user and system, seconds.
double cpu_seconds();
/// Largest resident memory of this process so far, bytes.
std::uint64_t peak_memory_bytes();
/// Memory of the machine, bytes; 0 if unknown.
std::uint64_t physical_memory_bytes();

/// Memory that this process can still have without anybody being killed, bytes: what the machine
/// can free and swap, within the limits of the control group (as batch schedulers set them) and of
/// the process (`ulimit -v`); 0 if unknown.
std::uint64_t available_memory_bytes();

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
