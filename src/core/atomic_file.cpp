#include "core/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
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

std::string temporary_start(const fs::path& path) {
  return std::string(".").append(path.stem().string()).append(".");
}
std::string temporary_end(const fs::path& path) {
  return std::string(".partial").append(path.extension().string());
}

/// In the folder of the target, hidden, and not shared by two processes or threads that write the
/// same file.
fs::path temporary_path(const fs::path& path) {
  static std::atomic<unsigned> counter{0};
  const std::string mark = std::to_string(::getpid()) + "." + std::to_string(counter++);
  return path.parent_path() / (temporary_start(path) + mark + temporary_end(path));
}

/// The process that writes, or wrote, the temporary file `name` for `path`; 0 if it is none of its.
pid_t writer_of(const fs::path& path, const std::string& name) {
  const std::string start = temporary_start(path);
  if (!name.starts_with(start) || !name.ends_with(temporary_end(path))) return 0;
  pid_t process = 0;
  const char* digits = name.data() + start.size();
  const auto [stopped, error] = std::from_chars(digits, name.data() + name.size(), process);
  return error == std::errc() && *stopped == '.' && process > 0 ? process : 0;
}

fs::path behind_link(const fs::path& path) {
  std::error_code error;
  return fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : path;
}

int write_all(File& file, std::span<const std::span<const std::byte>> pieces) {
  for (const std::span<const std::byte> piece : pieces) {
    if (const int reason = file.write(piece); reason != 0) return reason;
  }
  return 0;
}

int write_and_sync(File& file, std::span<const std::span<const std::byte>> pieces) {
  int reason = write_all(file, pieces);
  if (reason == 0) reason = file.sync();
  return reason == 0 ? file.close() : reason;
}
}  // namespace

void write_file_atomically(const fs::path& path, std::span<const std::byte> content) {
  write_file_atomically(path, std::span(&content, 1));
}

void remove_abandoned_parts(const fs::path& path) {
  const fs::path target = behind_link(path);
  const fs::path folder = target.parent_path();
  std::error_code error;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(folder.empty() ? fs::path(".") : folder, error)) {
    const pid_t process = writer_of(target, entry.path().filename().string());
    // Signal 0 is not sent: it only asks whether the process exists.
    if (process == 0 || ::kill(process, 0) == 0 || errno != ESRCH) continue;
    ::unlink(entry.path().c_str());
  }
}

void write_file_atomically(const fs::path& path,
                           std::span<const std::span<const std::byte>> pieces) {
  // Through a symbolic link the file it points to is replaced, not the link.
  const fs::path target = behind_link(path);
  if (target.filename().empty()) fail(path, EISDIR);

  struct stat old {};
  const bool exists = ::stat(target.c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode)) fail(path, EISDIR);
  if (exists && !S_ISREG(old.st_mode)) {
    File device(target, O_WRONLY);
    if (!device.is_open()) fail(path, errno);
    if (const int reason = write_all(device, pieces); reason != 0) fail(path, reason);
    return;
  }
  // Renaming would replace a file that its owner has protected.
  if (exists && ::access(target.c_str(), W_OK) != 0) fail(path, errno);

  const fs::path temporary = temporary_path(target);
  File file(temporary, O_WRONLY | O_CREAT | O_EXCL);
  if (!file.is_open()) fail(path, errno);
  int reason = exists ? file.take_mode_of(old) : 0;
  if (reason == 0) reason = write_and_sync(file, pieces);
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
