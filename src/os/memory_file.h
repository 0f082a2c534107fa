#pragma once
#include <string>
#include <string_view>

namespace ajar {

/// Bytes as a file that has a path but no name on the disk, for libraries that open files by their
/// names. It is gone with the object.
class MemoryFile {
 public:
  /// Raises IoError if the system has no room for it.
  explicit MemoryFile(std::string_view bytes);
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  /// Valid in this process.
  const std::string& path() const { return path_; }

 private:
  int descriptor_;
  std::string path_;
};

}  // namespace ajar
