#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace ajar::fuzz {

/// A file in a folder of this process alone, for readers that want a path; gone with the process.
/// `extension`: with its dot. Each call replaces the file of that extension.
std::string private_file(std::span<const std::uint8_t> content, const std::string& extension);

}  // namespace ajar::fuzz
