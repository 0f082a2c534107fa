#include "os/regular_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "core/error.h"
#include "os/available_memory.h"

namespace ajar {

namespace {

/// Closes a file descriptor at the end of a scope.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return fd_; }

 private:
  int fd_;
};

std::string reason_of(int error) { return std::system_category().message(error); }

[[noreturn]] void fail(const char* what, const std::string& path, const std::string& reason) {
  throw IoError(std::string("cannot ") + what + " \"" + path + "\": " + reason);
}

/// Empty for regular files.
std::string kind_complaint(mode_t mode) {
  if (S_ISREG(mode)) return {};
  const char* kind = S_ISDIR(mode)                    ? "a folder"
                     : S_ISFIFO(mode)                 ? "a named pipe"
                     : S_ISSOCK(mode)                 ? "a socket"
                     : S_ISCHR(mode) || S_ISBLK(mode) ? "a device"
                                                      : "something else";
  return std::string("it is ") + kind + ", and only regular files can be read";
}

}  // namespace

std::string reading_complaint(const std::string& path) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0) return reason_of(errno);
  return kind_complaint(status.st_mode);
}

FileBytes read_file(const std::string& path) {
  // Non-blocking: a file replaced by a pipe since it was named must not hang the program, either.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.get() < 0) fail("open", path, reason_of(errno));
  struct stat status = {};
  if (::fstat(file.get(), &status) != 0) fail("read", path, reason_of(errno));
  if (const std::string complaint = kind_complaint(status.st_mode); !complaint.empty()) {
    fail("read", path, complaint);
  }
  const auto size = static_cast<std::size_t>(status.st_size);
  if (const std::string preparation_cut = memory_shortage(size); !preparation_cut.empty()) {
    fail("read", path, "it " + preparation_cut);
  }
  std::unique_ptr<char[]> bytes(new char[size > 0 ? size : 1]);
  std::size_t done = 0;
  while (done < size) {
    const ssize_t count = ::read(file.get(), bytes.get() + done, size - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail("read", path, reason_of(errno));
    if (count == 0) break;
    done += static_cast<std::size_t>(count);
  }
  return {std::move(bytes), done};
}

}  // namespace ajar
