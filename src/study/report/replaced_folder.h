#pragma once
#include <filesystem>

namespace ajar {

/// A folder that is made beside its place and put there in one step, or not at all.
class ReplacedFolder {
 public:
  /// Makes the temporary folder, hidden, beside `target`. Raises IoError.
  explicit ReplacedFolder(const std::filesystem::path& target);
  ReplacedFolder(const ReplacedFolder&) = delete;
  ReplacedFolder& operator=(const ReplacedFolder&) = delete;
  /// Removes the temporary folder and, after `commit`, the earlier target.
  ~ReplacedFolder();

  /// Where to write until `commit`.
  const std::filesystem::path& path() const { return temporary_; }
  /// Puts the folder at its place. Raises IoError; the target is then as it was.
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
};

}  // namespace ajar
