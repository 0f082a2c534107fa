#include "core/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "core/error.h"

namespace ajar {

namespace {
namespace fs = std::filesystem;

/// `reason` is an errno.
[[noreturn]] void fail(const fs::path& path, int reason) {
  std::string text =
      "cannot write \"" + path.string() + "\": " + std::system_category().message(reason);
  const fs::path folder = path.parent_path();
  std::error_code ignored;
  if (reason == ENOENT && !folder.empty() && !fs::exists(folder, ignored)) {
    text += " (there is no folder \"" + folder.string() + "\")";
  }
  throw IoError(text);
}

class File {
 public:
  File(const fs::path& path, int flags)
      : descriptor_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  bool is_open() const { return descriptor_ >= 0; }
  /// These return 0 or an errno.
  int write(std::span<const std::byte> content) {
    while (!content.empty()) {
      const ssize_t written = ::write(descriptor_, content.data(), content.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return errno;
      content = content.subspan(static_cast<std::size_t>(written));
    }
    return 0;
  }
  int sync() { return ::fsync(descriptor_) == 0 ? 0 : errno; }
  int take_mode_of(const struct stat& other) {
    return ::fchmod(descriptor_, other.st_mode & 07777) == 0 ? 0 : errno;
  }
  int close() { return ::close(std::exchange(descriptor_, -1)) == 0 ? 0 : errno; }

 private:
  int descriptor_;
};

/// In the folder of the target, hidden, and not shared by two processes or threads that write the
/// same file.
fs::path temporary_path(const fs::path& path) {
  static std::atomic<unsigned> counter{0};
  const std::string mark = std::to_string(::getpid()) + "." + std::to_string(counter++);
  return path.parent_path() /
         ("." + path.stem().string() + "." + mark + ".partial" + path.extension().string());
}

int write_and_sync(File& file, std::span<const std::byte> content) {
  int reason = file.write(content);
  if (reason == 0) reason = file.sync();
  return reason == 0 ? file.close() : reason;
}
}  // namespace

void write_file_atomically(const fs::path& path, std::span<const std::byte> content) {
  // Through a symbolic link the file it points to is replaced, not the link.
  std::error_code error;
  const fs::path target = fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : path;
  if (target.filename().empty()) fail(path, EISDIR);

  struct stat old {};
  const bool exists = ::stat(target.c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode)) fail(path, EISDIR);
  if (exists && !S_ISREG(old.st_mode)) {
    File device(target, O_WRONLY);
    if (!device.is_open()) fail(path, errno);
    if (const int reason = device.write(content); reason != 0) fail(path, reason);
    return;
  }
  // Renaming would replace a file that its owner has protected.
  if (exists && ::access(target.c_str(), W_OK) != 0) fail(path, errno);

  const fs::path temporary = temporary_path(target);
  File file(temporary, O_WRONLY | O_CREAT | O_EXCL);
  if (!file.is_open()) fail(path, errno);
  int reason = exists ? file.take_mode_of(old) : 0;
  if (reason == 0) reason = write_and_sync(file, content);
  if (reason == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) reason = errno;
  if (reason != 0) {
    ::unlink(temporary.c_str());
    fail(path, reason);
  }
  // The rename itself must reach the disk; file systems that cannot do this are no reason to fail.
  const fs::path folder = target.parent_path();
  File directory(folder.empty() ? fs::path(".") : folder, O_RDONLY | O_DIRECTORY);
  if (directory.is_open()) directory.sync();
}

}  // namespace ajar
