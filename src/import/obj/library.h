#pragma once
#include <tiny_obj_loader.h>

#include <map>
#include <set>
#include <string>
#include <string_view>
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

  /// Reads the files that a line names, each once; warns of those that are not there. `where` names
  /// them. A name may have spaces in it if it is the only one of its line.
  void load(const SourceLocation& where, std::string_view names);
  /// Null if no file has it.
  const Description* find(const std::string& material) const;
  std::vector<std::string> names() const;

 private:
  /// True if there is such a file; its materials are known then.
  bool load_if_there(const SourceLocation& where, const std::string& file, std::string& reason);

  FileAccess& files_;
  Warnings& warnings_;
  std::set<std::string> loaded_;
  std::map<std::string, Description> materials_;
};

/// A name without the spaces around it.
std::string trimmed(std::string_view name);

}  // namespace ajar::obj
