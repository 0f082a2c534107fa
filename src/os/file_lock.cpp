#include "os/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <functional>
#include <utility>

#include "core/error.h"

namespace ajar {

namespace fs = std::filesystem;

namespace {

bool is_open_at(int file, const fs::path& path) {
  struct stat opened {};
  struct stat there {};
  return ::fstat(file, &opened) == 0 && ::stat(path.c_str(), &there) == 0 &&
         opened.st_ino == there.st_ino && opened.st_dev == there.st_dev;
}

}  // namespace

FileLock::FileLock(fs::path lock_file, const std::string& busy) : path_(std::move(lock_file)) {
  while (true) {
    file_ = ::open(path_.c_str(), O_CREAT | O_RDWR | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (file_ < 0) return;
    const bool is_locked = ::flock(file_, LOCK_EX | LOCK_NB) == 0;
    const bool is_busy = !is_locked && errno == EWOULDBLOCK;
    // Its holder may have removed it since it was opened.
    if (is_locked && is_open_at(file_, path_)) return;
    ::close(std::exchange(file_, -1));
    if (is_busy) throw IoError(busy);
    if (!is_locked) return;
  }
}

FileLock::FileLock(FileLock&& other) noexcept
    : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)) {}

FileLock::~FileLock() {
  if (file_ < 0) return;
  // Removed while it is still held, so that no other process's file is.
  ::unlink(path_.c_str());
  ::close(file_);
}

fs::path lock_file_of(const fs::path& path) {
  std::error_code error;
  const fs::path target = fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : path;
  std::string name = target.filename().string();
  constexpr std::size_t kLongestName = 200;  // below the 255 bytes of file systems
  if (name.size() > kLongestName) {
    name = name.substr(0, kLongestName) + std::to_string(std::hash<std::string>()(name));
  }
  return target.parent_path() / ("." + name + ".lock");
}

}  // namespace ajar
