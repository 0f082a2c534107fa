#pragma once
#include <filesystem>
#include <string>

namespace ajar {

/// Reason why a file cannot be loaded as a library by this program, e.g. "it is cut short"; empty
/// if there is none. Checked before the system's loader runs: that waits for named pipes, and a
/// truncated file ends the program that loads it (SIGBUS). Reads the structures that lead the
/// loader through the file (ELF), not the code and the data in it.
std::string library_complaint(const std::filesystem::path& path);

}  // namespace ajar
