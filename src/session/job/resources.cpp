#include "session/job/resources.h"

#include <sys/resource.h>

#include <ctime>

namespace ajar {

namespace {

double to_seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

rusage usage_of_process() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage;
}

}  // namespace

double cpu_seconds() {
  const rusage usage = usage_of_process();
  return to_seconds(usage.ru_utime) + to_seconds(usage.ru_stime);
}

double thread_cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::uint64_t peak_memory_bytes() {
  // Linux counts in KiB.
  return static_cast<std::uint64_t>(usage_of_process().ru_maxrss) * 1024U;
}

}  // namespace ajar
