#pragma once
#include <tiny_obj_loader.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/warnings.h"
#include "import/common/file_access.h"

namespace ajar::obj {

/// A material as its file describes it.
struct Description {
  tinyobj::material_t values;
  SourceLocation where;
};

/// The material files that a scene names.
class Library {
 public:
  Library(FileAccess& files, Warnings& warnings) : files_(files), warnings_(warnings) {}

  /// Reads a file, once; warns if it is not there. `where` names it.
  void load(const SourceLocation& where, const std::string& file);
  /// Null if no file has it.
  const Description* find(const std::string& material) const;
  std::vector<std::string> names() const;

 private:
  FileAccess& files_;
  Warnings& warnings_;
  std::set<std::string> loaded_;
  std::map<std::string, Description> materials_;
};

/// A name without the spaces around it.
std::string trimmed(std::string_view name);
/// A path with the separators of this system.
std::string portable_path(std::string path);

}  // namespace ajar::obj
