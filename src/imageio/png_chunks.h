#pragma once
#include <cstdint>
#include <string>

namespace ajar {

/// What is wrong with the chunks of a PNG file: its library makes room for what a chunk claims to
/// hold before it reads it. Empty if nothing is, or if this is no such file. `file_bytes`: its
/// size. Source: W3C 2003, "Portable Network Graphics Specification", section 5.3.
std::string png_chunk_complaint(const std::string& path, std::uint64_t file_bytes);

}  // namespace ajar
