#pragma once
#include <string>
#include <vector>

#include "import/common/file_access.h"

namespace ajar::mitsuba {

/// Where the files that a scene names are looked for: in its own folder, in those of the files it
/// includes, and in those it names by `<path>`.
class SearchPath {
 public:
  explicit SearchPath(FileAccess& files) : files_(files) {}

  /// `folder` is relative to that of the scene, or absolute.
  void add(const std::string& folder);
  /// `name` relative to the scene's folder, or absolute: in the first folder that has it, or in the
  /// scene's own if none has.
  std::string find(const std::string& name) const;
  FileAccess& files() const { return files_; }

 private:
  FileAccess& files_;
  std::vector<std::string> folders_;
};

}  // namespace ajar::mitsuba
