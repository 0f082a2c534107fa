#include "os/available_memory.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>

namespace ajar {

namespace {

/// Reserve: the rest of the program, and omissions of estimates.
constexpr double kUsableShare = 0.95;

/// The number in a file that has nothing else; empty if there is none ("max", or no such file).
std::optional<std::uint64_t> number_in(const std::string& path) {
  std::ifstream file(path);
  std::uint64_t number = 0;
  return file >> number ? std::optional(number) : std::nullopt;
}

/// Memory that the kernel can give: free, used for caches, or swap. Linux counts in KiB.
std::optional<std::uint64_t> free_on_machine() {
  std::ifstream file("/proc/meminfo");
  std::optional<std::uint64_t> bytes;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string name;
    std::uint64_t kibibytes = 0;
    if (!(words >> name >> kibibytes)) continue;
    if (name == "MemAvailable:" || name == "SwapFree:") {
      bytes = bytes.value_or(0) + 1024 * kibibytes;
    }
  }
  return bytes;
}

/// The control group (version 2) of this process and those around it: the tightest limit.
std::optional<std::uint64_t> free_in_group() {
  std::ifstream file("/proc/self/cgroup");
  std::string group;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("0::/")) group = line.substr(3);
  }
  std::optional<std::uint64_t> least;
  while (!group.empty()) {
    const std::string folder = "/sys/fs/cgroup" + group;
    const auto limit = number_in(folder + "/memory.max");
    const auto used = number_in(folder + "/memory.current");
    if (limit && used) {
      const std::uint64_t left = *limit > *used ? *limit - *used : 0;
      least = std::min(left, least.value_or(left));
    }
    if (group == "/") break;
    group.erase(std::max<std::size_t>(1, group.rfind('/')));
  }
  return least;
}

/// Within `ulimit -v`.
std::optional<std::uint64_t> free_in_process() {
  rlimit limit{};
  const auto pages = number_in("/proc/self/statm");
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY || !pages) {
    return std::nullopt;
  }
  const std::uint64_t used = *pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  return limit.rlim_cur > used ? limit.rlim_cur - used : 0;
}

}  // namespace

std::uint64_t physical_memory_bytes() {
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long page_size = sysconf(_SC_PAGESIZE);
  if (pages <= 0 || page_size <= 0) return 0;
  return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page_size);
}

std::uint64_t available_memory_bytes() {
  std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
  for (const auto& bytes : {free_on_machine(), free_in_group(), free_in_process()}) {
    least = std::min(least, bytes.value_or(least));
  }
  return least == std::numeric_limits<std::uint64_t>::max() ? physical_memory_bytes() : least;
}

bool fits_into_memory(std::uint64_t bytes, std::uint64_t available) {
  return available == 0 ||
         static_cast<double>(bytes) <= kUsableShare * static_cast<double>(available);
}

std::string memory_shortage(std::uint64_t bytes) {
  // For fewer bytes the check costs more than the allocation.
  constexpr std::uint64_t kSmall = std::uint64_t{1} << 24U;
  if (bytes <= kSmall) return {};
  const std::uint64_t available = available_memory_bytes();
  if (fits_into_memory(bytes, available)) return {};
  return fmt::format("needs {} of memory, and {} are free here", bytes_text(bytes),
                     bytes_text(available));
}

std::string bytes_text(std::uint64_t bytes) {
  const auto number = static_cast<double>(bytes);
  return number < 1e9 ? fmt::format("{:.0f} MB", 1e-6 * number)
                      : fmt::format("{:.1f} GB", 1e-9 * number);
}

}  // namespace ajar
