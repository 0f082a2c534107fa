#include "import/common/file_access.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string_view>

#include "core/error.h"
#include "core/printable_text.h"

namespace ajar {
namespace {

namespace fs = std::filesystem;

constexpr WarningKind kSpelling{Effect::None,
                                "files are spelt in another way than the scene has it"};

/// True if `file` is in the folder or below once all links are followed, those of the folder, too.
bool is_inside(const fs::path& folder, const fs::path& file) {
  std::error_code error;
  fs::path root = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, error);
  if (error) return true;  // neither can be read
  if (!root.has_filename()) root = root.parent_path();
  const fs::path target = fs::weakly_canonical(file, error);
  if (error) return true;
  return std::mismatch(root.begin(), root.end(), target.begin(), target.end()).first == root.end();
}

/// A path of systems that have backslashes between folders. Where they began an escape of a string
/// ("\textures"), it is undone: no name has control characters in it.
std::string with_slashes(const std::string& name) {
  constexpr std::string_view kEscaped = "\b\f\n\r\t";
  constexpr std::string_view kLetters = "bfnrt";
  std::string path;
  for (const char c : name) {
    const std::size_t escape = kEscaped.find(c);
    path += c == '\\' || escape != std::string_view::npos ? '/' : c;
    if (escape != std::string_view::npos) path += kLetters[escape];
  }
  return path;
}

bool are_same_letters(std::string_view a, std::string_view b) {
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return small(x) == small(y); });
}

/// The only file or folder of that name in either case; nothing if there are none or several.
std::optional<fs::path> entry_of(const fs::path& folder, const std::string& name) {
  std::error_code error;
  std::optional<fs::path> found;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const fs::path candidate = entry->path().filename();
    if (!are_same_letters(candidate.string(), name)) continue;
    if (found) return std::nullopt;
    found = candidate;
  }
  return found;
}

/// `name` as the file system has it, folder by folder.
std::optional<std::string> in_other_case(const fs::path& folder, const fs::path& name) {
  fs::path found = name.root_path();
  const fs::path base = folder.empty() ? fs::path(".") : folder;
  std::error_code error;
  for (const fs::path& part : name.relative_path()) {
    if (fs::exists(base / found / part, error)) {
      found /= part;
    } else if (const std::optional<fs::path> entry = entry_of(base / found, part.string())) {
      found /= *entry;
    } else {
      return std::nullopt;
    }
  }
  return found.string();
}

}  // namespace

std::string FileAccess::path_of(const std::string& name) const {
  return (fs::path(base_folder_) / name).lexically_normal().string();
}

bool FileAccess::is_there(const std::string& name) const {
  const std::string path = path_of(name);
  if (provider_ && provider_(path)) return true;
  std::error_code error;
  return fs::exists(path, error);
}

std::string FileAccess::meant_by(const std::string& name) const {
  if (is_there(name)) return name;
  const std::string portable = with_slashes(name);
  if (portable != name && is_there(portable)) return portable;
  return in_other_case(base_folder_, portable).value_or(name);
}

std::string FileAccess::resolve(const std::string& name, const SourceLocation& where) {
  // A zero byte would end the name early in every call to the system.
  if (name.find('\0') != std::string::npos) throw IoError("a file name contains a zero byte");
  const std::string meant = meant_by(name);
  if (meant != name && where.file) {
    warnings_.add(kSpelling, where,
                  "there is no \"" + printable_line(name) + "\": \"" + printable_line(meant) +
                      "\" is taken for it",
                  printable_line(name));
  }
  const fs::path path = path_of(meant);
  if (provider_ && provider_(path.string())) return path.string();
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  return *named_.insert(error ? path.string() : absolute.lexically_normal().string()).first;
}

std::string FileAccess::resolve_inside(const std::string& name, const SourceLocation& where) {
  const fs::path path(with_slashes(name));
  const fs::path normal = path.lexically_normal();
  if (path.is_absolute() || (!normal.empty() && *normal.begin() == "..")) {
    throw IoError("\"" + printable_line(name) +
                  "\" is outside of the folder of the scene, where files are not looked for");
  }
  if (name.find('\0') != std::string::npos) return resolve(name);  // raises
  const std::string place = path_of(meant_by(name));
  if (!(provider_ && provider_(place)) && !is_inside(base_folder_, place)) {
    throw IoError("\"" + printable_line(name) +
                  "\" is a link that leads out of the folder of the scene, where files are not "
                  "looked for");
  }
  return resolve(name, where);
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
