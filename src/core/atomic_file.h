#pragma once
#include <cstddef>
#include <filesystem>
#include <span>

namespace ajar {

/// Replaces a file in one step: writes a temporary file in the same folder, forces it to disk, and
/// renames it. Whatever happens (disk full, kill −9, power), the path holds either the old content
/// or the new, whole. Raises IoError with the reason; the temporary file is then gone and the old
/// file untouched. Paths that exist but are not regular files (/dev/stdout, pipes) are written
/// directly.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> content);

}  // namespace ajar
