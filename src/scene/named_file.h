#pragma once
#include <optional>
#include <string>

#include "os/memory_file.h"
#include "scene/desc/scene_desc.h"

namespace ajar {

/// A file that a scene names, wherever it is: on the disk, or inside of another.
class NamedFile {
 public:
  /// Raises IoError if the system has no room for it.
  NamedFile(const std::string& name, const desc::EmbeddedFiles& embedded) : path_(name) {
    const auto held = embedded.find(name);
    if (held == embedded.end()) return;
    memory_.emplace(*held->second);
    path_ = memory_->path();
  }
  /// Valid as long as this is.
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::optional<MemoryFile> memory_;
};

}  // namespace ajar
