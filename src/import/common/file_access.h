#pragma once
#include <set>
#include <string>

#include "core/warnings.h"
#include "import/common/text_encoding.h"
#include "import/file_provider.h"

namespace ajar {

/// Finds the files that a scene refers to: relative to the folder of the scene, first at the
/// provider, then on the disk. A name that no file has is taken as other systems have it: with
/// backslashes between folders, then with letters of either case if but one file fits.
class FileAccess {
 public:
  FileAccess(std::string base_folder, FileProvider provider, Warnings& warnings)
      : base_folder_(std::move(base_folder)), provider_(std::move(provider)), warnings_(warnings) {}

  /// Location of `name`: as the provider knows it, or an absolute path on the disk. A file of
  /// another spelling is a warning where it is named, if `where` is given.
  std::string resolve(const std::string& name, const SourceLocation& where = {});
  /// Resolves names of untrusted files: raises IoError, with the reason, for names that lead out of
  /// the folder of the scene, by themselves or by links.
  std::string resolve_inside(const std::string& name, const SourceLocation& where = {});
  /// Reads a file resolved by `resolve`. Raises IoError.
  FileBytes load(const std::string& resolved) const;
  /// Loads text, in UTF-8 (`in_utf8`).
  FileBytes load_text(const std::string& resolved) const { return in_utf8(load(resolved)); }
  bool exists(const std::string& resolved) const;
  /// True if there is a file of this very name, before it is resolved.
  bool is_there(const std::string& name) const;
  /// All paths on the disk that were resolved so far.
  const std::set<std::string>& named() const { return named_; }

 private:
  std::string path_of(const std::string& name) const;
  /// `name`, or the name of the only file that matches it.
  std::string meant_by(const std::string& name) const;

  std::string base_folder_;
  FileProvider provider_;
  Warnings& warnings_;
  std::set<std::string> named_;
};

}  // namespace ajar
