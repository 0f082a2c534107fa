#pragma once
#include <cstdint>
#include <string>

namespace ajar {

/// What is wrong with the sizes in the header of an OpenEXR file, which its library believes before
/// it reads on: attributes that are larger than the file, more pixels than its bytes could hold.
/// Empty if nothing is, or if this is no such file. `file_bytes`: its size. Source: "OpenEXR File
/// Layout", openexr.com.
std::string exr_header_complaint(const std::string& path, std::uint64_t file_bytes);

}  // namespace ajar
