#pragma once
#include <filesystem>

namespace ajar::study {

/// Keeps two studies from writing into one folder, until destroyed. It ends with the program,
/// however that ends.
class FolderLock {
 public:
  /// Raises IoError if another program holds the lock, or if the folder cannot be written.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int file_;
};

}  // namespace ajar::study
