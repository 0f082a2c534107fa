#include "os/memory_file.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "core/error.h"

namespace ajar {
namespace {

std::string reason() { return std::system_category().message(errno); }

}  // namespace

MemoryFile::MemoryFile(std::string_view bytes)
    : descriptor_(::memfd_create("ajar", MFD_CLOEXEC)),
      path_("/proc/self/fd/" + std::to_string(descriptor_)) {
  if (descriptor_ < 0) throw IoError("cannot make a file in memory: " + reason());
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      const std::string why = reason();
      ::close(descriptor_);
      throw IoError("cannot write a file in memory: " + why);
    }
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

MemoryFile::~MemoryFile() { ::close(descriptor_); }

}  // namespace ajar
