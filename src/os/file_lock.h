#pragma once
#include <filesystem>
#include <string>

namespace ajar {

/// Keeps two programs from writing to the same place, until destroyed. It ends with the program,
/// however that ends; stale lock files do not block.
class FileLock {
 public:
  /// Raises IoError with the message `busy` if another program holds it. Where no lock can be made
  /// (a folder that cannot be written, a file system without locks) there is none.
  FileLock(std::filesystem::path lock_file, const std::string& busy);
  ~FileLock();
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&&) = delete;
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  std::filesystem::path path_;
  int file_ = -1;
};

/// The lock file for `path`: hidden, beside it, or beside what it points to if it is a link.
std::filesystem::path lock_file_of(const std::filesystem::path& path);

}  // namespace ajar
