#pragma once
#include <cstdint>
#include <string>

namespace ajar {

/// Why an image of a format that only OpenImageIO reads is not given to it, e.g. "it is a DPX, …";
/// empty if nothing speaks against it. Readers of some formats (2.4) believe what a file says of
/// itself, and end the program if that is wrong: these are refused, or looked at before.
/// `file_bytes`: its size.
std::string unsafe_format_complaint(const std::string& path, std::uint64_t file_bytes);

}  // namespace ajar
