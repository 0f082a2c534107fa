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
/// The same for a file of several pieces, one after the other.
void write_file_atomically(const std::filesystem::path& path,
                           std::span<const std::span<const std::byte>> pieces);

/// Removes what processes that are gone (kill −9) left beside `path` of files they were writing
/// there. For folders that one machine writes into; raises nothing.
void remove_abandoned_parts(const std::filesystem::path& path);

}  // namespace ajar
