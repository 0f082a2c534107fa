#pragma once
#include <set>
#include <string>

#include "import/file_provider.h"

namespace ajar {

/// Finds the files that a scene refers to: relative to the folder of the scene, first at the
/// provider, then on the disk.
class FileAccess {
 public:
  FileAccess(std::string base_folder, FileProvider provider)
      : base_folder_(std::move(base_folder)), provider_(std::move(provider)) {}

  /// Where `name` is: as the provider knows it, or an absolute path on the disk.
  std::string resolve(const std::string& name);
  /// The same for formats whose files come from strangers: raises IoError, with the reason, for
  /// names that lead out of the folder of the scene, by themselves or by links.
  std::string resolve_inside(const std::string& name);
  /// Reads what `resolve` returned. Raises IoError.
  FileBytes load(const std::string& resolved) const;
  bool exists(const std::string& resolved) const;
  /// All paths on the disk that were resolved so far.
  const std::set<std::string>& named() const { return named_; }

 private:
  std::string base_folder_;
  FileProvider provider_;
  std::set<std::string> named_;
};

}  // namespace ajar
