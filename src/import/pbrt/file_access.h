#pragma once
#include <string>

#include "import/file_bytes.h"

namespace ajar::pbrt {

/// Finds the files that a scene refers to: relative to the folder of the scene, first at the
/// provider, then on the disk.
class FileAccess {
 public:
  FileAccess(std::string base_folder, FileProvider provider)
      : base_folder_(std::move(base_folder)), provider_(std::move(provider)) {}

  /// Where `name` is: as the provider knows it, or an absolute path on the disk.
  std::string resolve(const std::string& name) const;
  /// Reads what `resolve` returned. Raises IoError.
  FileBytes load(const std::string& resolved) const;
  bool exists(const std::string& resolved) const;

 private:
  std::string base_folder_;
  FileProvider provider_;
};

}  // namespace ajar::pbrt
