#pragma once
#include <link.h>

#include <cstddef>
#include <filesystem>
#include <string>

namespace ajar::testing {

/// A library of this process, the standard one of C++, which has none of Open Image Denoise's
/// functions; empty if it is linked into the program.
inline std::filesystem::path loaded_library() {
  std::filesystem::path found;
  dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void* to) {
        const std::string name = info->dlpi_name;
        if (name.find("libstdc++") != std::string::npos) {
          *static_cast<std::filesystem::path*>(to) = name;
        }
        return 0;
      },
      &found);
  return found;
}

}  // namespace ajar::testing
