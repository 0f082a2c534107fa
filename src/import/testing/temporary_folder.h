#pragma once
#include <cstdlib>
#include <filesystem>
#include <string>

namespace ajar {

/// A new folder for files, which is removed with all that is in it at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    // mkdtemp replaces these six letters.
    std::string pattern = (std::filesystem::temp_directory_path() / "ajar_test_XXXXXX").string();
    path_ = mkdtemp(pattern.data());
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace ajar
