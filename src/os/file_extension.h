#pragma once
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

namespace ajar {

/// ".exr" for "Room.EXR": in small letters; empty if there is none.
inline std::string file_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace ajar
