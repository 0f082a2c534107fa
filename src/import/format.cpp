#include "import/format.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "core/error.h"
#include "os/file_extension.h"

namespace ajar {
namespace {

bool is_read(const Format& /*format*/) { return true; }
bool is_written(const Format& format) { return format.write != nullptr; }

const Format* find_format(const std::string& extension, bool (*is_meant)(const Format&)) {
  for (const Format& format : formats()) {
    const auto& own = format.extensions;
    if (is_meant(format) && std::find(own.begin(), own.end(), extension) != own.end()) {
      return &format;
    }
  }
  return nullptr;
}

std::string unknown_extension(const std::string& kind, const std::string& extension,
                              bool (*is_meant)(const Format&)) {
  std::vector<std::string> valid;
  for (const Format& format : formats()) {
    if (!is_meant(format)) continue;
    valid.insert(valid.end(), format.extensions.begin(), format.extensions.end());
  }
  if (extension.empty()) {
    return fmt::format("the name has no extension, which tells the {}. Valid: {}", kind,
                       fmt::join(valid, ", "));
  }
  return unknown_name_message(kind, extension, valid);
}

}  // namespace

const Format& format_of(const std::string& path) {
  const std::string extension = file_extension(path);
  if (const Format* format = find_format(extension, is_read)) return *format;
  throw SceneError({std::make_shared<const std::string>(path), 0, 0},
                   unknown_extension("kind of scene file", extension, is_read));
}

const Format& format_to_write(const std::string& path) {
  const std::string extension = file_extension(path);
  if (const Format* format = find_format(extension, is_written)) return *format;
  throw UsageError(path + ": " +
                   unknown_extension("kind of scene file to write", extension, is_written));
}

std::string writable_formats() {
  std::string text;
  for (const Format& format : formats()) {
    if (!is_written(format)) continue;
    text += (text.empty() ? "" : ", ") + format.name + " (";
    for (std::size_t i = 0; i < format.extensions.size(); ++i) {
      text += (i > 0 ? ", " : "") + format.extensions[i];
    }
    text += ")";
  }
  return text;
}

}  // namespace ajar
