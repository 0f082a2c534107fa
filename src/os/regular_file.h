#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

/// The only way to input files. Other than regular files are refused before they are opened or
/// read: a named pipe or a terminal would be waited for, a device such as /dev/zero never ends.
namespace ajar {

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

/// Why `path` cannot be read as a file, e.g. "it is a named pipe, and only regular files can be
/// read"; empty if it can. For libraries that open files by their names.
std::string reading_complaint(const std::string& path);

/// Reads a regular file in one go. Raises IoError, with the path, if it is missing, not a regular
/// file, unreadable, or larger than the memory that is free.
FileBytes read_file(const std::string& path);

}  // namespace ajar
