#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

namespace ajar {

/// Replaces a file in one step: writes a temporary file in the same folder, forces it to disk, and
/// renames it. After any failure (disk full, kill −9, power), the path holds either the old content
/// or the new, whole. The file keeps its mode, and the links that lead to it stay. Raises IoError
/// with the reason, which may be that the file is write-protected; the temporary file is then gone
/// and the old file untouched. Paths that exist but are not regular files (/dev/stdout, >(…) of a
/// shell) are written directly, but for named pipes: to open one may take for ever. Nothing else in
/// the program writes files.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> content);
/// Writes a file of several pieces, one after the other.
void write_file_atomically(const std::filesystem::path& path,
                           std::span<const std::span<const std::byte>> pieces);
void write_file_atomically(const std::filesystem::path& path, std::string_view text);

/// Raises the IoError that `write_file_atomically` would raise now, but for a full disk, and leaves
/// everything as it is. Called before hours of work.
void check_file_can_be_written(const std::filesystem::path& path);

/// A name in the folder of `path` for its replacement: hidden, not longer for a longer name, and
/// not shared by two processes or threads that write the same file. A file of that name may exist.
std::filesystem::path temporary_path(const std::filesystem::path& path);

/// Removes temporary files of processes that ended early (kill −9) beside `path`. For folders that
/// one machine writes into; raises nothing.
void remove_abandoned_parts(const std::filesystem::path& path);

}  // namespace ajar
