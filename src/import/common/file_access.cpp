#include "import/common/file_access.h"

#include <algorithm>
#include <filesystem>

#include "core/error.h"
#include "core/printable_text.h"

namespace ajar {
namespace {

namespace fs = std::filesystem;

/// Whether `file` is in the folder or below once all links are followed, those of the folder, too.
bool is_inside(const fs::path& folder, const fs::path& file) {
  std::error_code error;
  fs::path root = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, error);
  if (error) return true;  // neither can be read
  if (!root.has_filename()) root = root.parent_path();
  const fs::path target = fs::weakly_canonical(file, error);
  if (error) return true;
  return std::mismatch(root.begin(), root.end(), target.begin(), target.end()).first == root.end();
}

}  // namespace

std::string FileAccess::resolve(const std::string& name) {
  // A zero byte would end the name early in every call to the system.
  if (name.find('\0') != std::string::npos) throw IoError("a file name contains a zero byte");
  const fs::path path = (fs::path(base_folder_) / name).lexically_normal();
  if (provider_ && provider_(path.string())) return path.string();
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  return *named_.insert(error ? path.string() : absolute.lexically_normal().string()).first;
}

std::string FileAccess::resolve_inside(const std::string& name) {
  const fs::path path(name);
  const fs::path normal = path.lexically_normal();
  if (path.is_absolute() || (!normal.empty() && *normal.begin() == "..")) {
    throw IoError("\"" + printable_line(name) +
                  "\" is outside of the folder of the scene, where files are not looked for");
  }
  const fs::path place = (fs::path(base_folder_) / name).lexically_normal();
  const bool is_provided = provider_ && provider_(place.string());
  if (!is_provided && name.find('\0') == std::string::npos && !is_inside(base_folder_, place)) {
    throw IoError("\"" + printable_line(name) +
                  "\" is a link that leads out of the folder of the scene, where files are not "
                  "looked for");
  }
  return resolve(name);
}

FileBytes FileAccess::load(const std::string& resolved) const {
  if (provider_) {
    if (const std::optional<std::string_view> bytes = provider_(resolved)) return FileBytes(*bytes);
  }
  return read_file(resolved);
}

bool FileAccess::exists(const std::string& resolved) const {
  if (provider_ && provider_(resolved)) return true;
  std::error_code error;
  return fs::is_regular_file(resolved, error);
}

}  // namespace ajar
