#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace ajar {

/// Serves files that are not on the disk (built-in scenes); empty for files it does not know. What
/// it returns must stay valid while the scene is imported.
using FileProvider = std::function<std::optional<std::string_view>(const std::string& path)>;

/// The contents of a file, owned or borrowed.
class FileBytes {
 public:
  explicit FileBytes(std::string_view borrowed) : view_(borrowed) {}
  FileBytes(std::unique_ptr<char[]> owned, std::size_t size)
      : owned_(std::move(owned)), view_(owned_.get(), size) {}
  std::string_view view() const { return view_; }

 private:
  std::unique_ptr<char[]> owned_;
  std::string_view view_;
};

/// Reads a regular file in one go. Raises IoError if it is missing, not a regular file or
/// unreadable.
FileBytes read_file(const std::string& path);

}  // namespace ajar
