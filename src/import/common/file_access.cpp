#include "import/common/file_access.h"

#include <filesystem>

#include "core/error.h"
#include "core/printable_text.h"

namespace ajar {

std::string FileAccess::resolve(const std::string& name) {
  // A zero byte would end the name early in every call to the system.
  if (name.find('\0') != std::string::npos) throw IoError("a file name contains a zero byte");
  const std::filesystem::path path =
      (std::filesystem::path(base_folder_) / name).lexically_normal();
  if (provider_ && provider_(path.string())) return path.string();
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(path, error);
  return *named_.insert(error ? path.string() : absolute.lexically_normal().string()).first;
}

std::string FileAccess::resolve_inside(const std::string& name) {
  const std::filesystem::path path(name);
  const std::filesystem::path normal = path.lexically_normal();
  if (path.is_absolute() || (!normal.empty() && *normal.begin() == "..")) {
    throw IoError("\"" + printable_line(name) +
                  "\" is outside of the folder of the scene, where files are not looked for");
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
  return std::filesystem::is_regular_file(resolved, error);
}

}  // namespace ajar
