#include "os/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <climits>
#include <csignal>
#include <functional>
#include <string>
#include <system_error>
#include <utility>

#include "core/error.h"

namespace ajar {

namespace {
namespace fs = std::filesystem;

/// Links in a row, as many as the kernel follows.
constexpr int kMostLinks = 40;

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
  throw IoError("cannot write \"" + path.string() + "\": " + reason);
}

/// `reason` is an errno.
[[noreturn]] void fail(const fs::path& path, int reason) {
  std::string text = std::system_category().message(reason);
  const fs::path folder = path.parent_path();
  std::error_code ignored;
  if (reason == ENOENT && !folder.empty() && !fs::exists(folder, ignored)) {
    text += " (there is no folder \"" + folder.string() + "\")";
  }
  const std::size_t length = path.filename().string().size();
  if (reason == ENAMETOOLONG && length > NAME_MAX) {
    text += " (it has " + std::to_string(length) + " bytes, of at most " +
            std::to_string(NAME_MAX) + ")";
  }
  fail(path, text);
}

class File {
 public:
  File() = default;
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  /// These return 0 or an errno.
  int open(const fs::path& path, int flags) {
    descriptor_ = ::open(path.c_str(), flags | O_CLOEXEC, 0666);
    return descriptor_ >= 0 ? 0 : errno;
  }
  int write(std::span<const std::byte> content) {
    while (!content.empty()) {
      const ssize_t written = ::write(descriptor_, content.data(), content.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return errno;
      content = content.subspan(static_cast<std::size_t>(written));
    }
    return 0;
  }
  int write_all(std::span<const std::span<const std::byte>> pieces) {
    for (const std::span<const std::byte> piece : pieces) {
      if (const int reason = write(piece); reason != 0) return reason;
    }
    return 0;
  }
  int sync() { return ::fsync(descriptor_) == 0 ? 0 : errno; }
  int take_mode_of(const struct stat& other) {
    return ::fchmod(descriptor_, other.st_mode & 07777) == 0 ? 0 : errno;
  }
  int close() { return ::close(std::exchange(descriptor_, -1)) == 0 ? 0 : errno; }

 private:
  int descriptor_ = -1;
};

/// Prefix of temporary files for `path`: a hash, as the name itself may have the greatest length
/// allowed.
std::string temporary_start(const fs::path& path) {
  std::array<char, 2 * sizeof(std::size_t)> digits{};
  const std::size_t hash = std::hash<std::string>()(path.filename().string());
  char* const end = std::to_chars(digits.begin(), digits.end(), hash, 16).ptr;
  return std::string(".ajar-").append(digits.begin(), end).append(".");
}
constexpr std::string_view kTemporaryEnd = ".partial";

/// The process that writes, or wrote, the temporary file `name` for `path`; 0 if it is none of its.
pid_t writer_of(const fs::path& path, const std::string& name) {
  const std::string start = temporary_start(path);
  if (!name.starts_with(start) || !name.ends_with(kTemporaryEnd)) return 0;
  pid_t process = 0;
  const char* digits = name.data() + start.size();
  const auto [stopped, error] = std::from_chars(digits, name.data() + name.size(), process);
  return error == std::errc() && *stopped == '.' && process > 0 ? process : 0;
}

/// Resolves symbolic links; the target need not exist.
fs::path behind_links(const fs::path& path) {
  fs::path target = path;
  for (int links = 0; links < kMostLinks; ++links) {
    std::error_code error;
    const fs::path next = fs::read_symlink(target, error);
    if (error) return target;
    target = target.parent_path() / next;
  }
  return target;
}

/// Output: a file whose content is replaced, or another sink of bytes.
struct Target {
  fs::path path;
  struct stat status {};
  bool exists = false;
  bool is_file = true;
};

/// True if it has a name on a disk, by which it is opened once more. Inherited ones (/dev/stdout,
/// the shell's >(…)) have none.
bool is_named_pipe(const fs::path& path) {
  std::error_code error;
  return fs::is_fifo(fs::symlink_status(behind_links(path), error));
}

/// Raises IoError for errors that show before anything is written.
Target examine(const fs::path& path) {
  Target target;
  target.exists = ::stat(path.c_str(), &target.status) == 0;
  if (!target.exists && errno != ENOENT) fail(path, errno);
  target.is_file = !target.exists || S_ISREG(target.status.st_mode);
  // Through a symbolic link the file it points to is replaced, not the link.
  target.path = target.is_file ? behind_links(path) : path;
  if (!target.is_file && is_named_pipe(path)) {
    fail(path, "it is a named pipe, at which a program waits until another reads");
  }
  if (target.path.filename().empty()) fail(path, path.empty() ? ENOENT : EISDIR);
  if (target.exists && S_ISDIR(target.status.st_mode)) fail(path, EISDIR);
  // Renaming would replace a file that its owner has protected.
  if (target.exists && ::access(target.path.c_str(), W_OK) != 0) fail(path, errno);
  return target;
}

/// A new file beside its target, gone at the end of the scope unless it was put there.
class TemporaryFile {
 public:
  /// Raises IoError that names `path`.
  TemporaryFile(const fs::path& path, const Target& target) : target_(target) {
    int reason = EEXIST;
    // Exclusive creation: neither a planted link is followed, nor the file of a killed process of
    // the same number replaced.
    while (reason == EEXIST) {
      path_ = temporary_path(target.path);
      reason = file_.open(path_, O_WRONLY | O_CREAT | O_EXCL);
    }
    if (reason != 0) fail(path, reason);
    is_there_ = true;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (is_there_) ::unlink(path_.c_str());
  }

  /// Returns 0 or an errno.
  int put_in_place(std::span<const std::span<const std::byte>> pieces) {
    int reason = target_.exists ? file_.take_mode_of(target_.status) : 0;
    if (reason == 0) reason = file_.write_all(pieces);
    if (reason == 0) reason = file_.sync();
    if (reason == 0) reason = file_.close();
    if (reason == 0 && ::rename(path_.c_str(), target_.path.c_str()) != 0) reason = errno;
    is_there_ = reason != 0;
    return reason;
  }

 private:
  const Target& target_;
  fs::path path_;
  File file_;
  bool is_there_ = false;
};
}  // namespace

fs::path temporary_path(const fs::path& path) {
  static std::atomic<unsigned> counter{0};
  const std::string mark = std::to_string(::getpid()) + "." + std::to_string(counter++);
  return path.parent_path() / (temporary_start(path) + mark).append(kTemporaryEnd);
}

void check_file_can_be_written(const fs::path& path) {
  const Target target = examine(path);
  if (!target.is_file) return;
  const TemporaryFile attempt(path, target);
}

void write_file_atomically(const fs::path& path, std::span<const std::byte> content) {
  write_file_atomically(path, std::span(&content, 1));
}

void write_file_atomically(const fs::path& path, std::string_view text) {
  write_file_atomically(path, std::as_bytes(std::span(text)));
}

void write_file_atomically(const fs::path& path,
                           std::span<const std::span<const std::byte>> pieces) {
  const Target target = examine(path);
  if (!target.is_file) {
    File device;
    int reason = device.open(path, O_WRONLY);
    if (reason == 0) reason = device.write_all(pieces);
    if (reason != 0) fail(path, reason);
    return;
  }
  TemporaryFile temporary(path, target);
  if (const int reason = temporary.put_in_place(pieces); reason != 0) fail(path, reason);
  // The rename itself must reach the disk; file systems that cannot do this are no reason to fail.
  const fs::path folder = target.path.parent_path();
  File directory;
  if (directory.open(folder.empty() ? fs::path(".") : folder, O_RDONLY | O_DIRECTORY) == 0) {
    directory.sync();
  }
}

void remove_abandoned_parts(const fs::path& path) {
  const fs::path target = behind_links(path);
  const fs::path folder = target.parent_path();
  std::error_code error;
  for (fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, error), end;
       !error && entry != end; entry.increment(error)) {
    const pid_t process = writer_of(target, entry->path().filename().string());
    // Signal 0 is not sent: it only asks whether the process exists.
    if (process == 0 || ::kill(process, 0) == 0 || errno != ESRCH) continue;
    ::unlink(entry->path().c_str());
  }
}

}  // namespace ajar
