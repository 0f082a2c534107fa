#pragma once
#include <filesystem>
#include <string>

namespace ajar {

/// Why a file cannot be loaded as a library by this program, e.g. "it is cut short"; empty if
/// nothing speaks against it. To be asked before the system's loader is: that waits for named
/// pipes, and a file that ends before what it promises ends the program that loads it (SIGBUS).
/// Looks at what leads the loader through the file (ELF), not at the code and the data in it.
std::string library_complaint(const std::filesystem::path& path);

}  // namespace ajar
