#pragma once
#include <cstdint>
#include <string>

namespace ajar {

/// Error in the sizes of an OpenEXR header, which its library would trust: attributes that are
/// larger than the file, more pixels than its bytes could hold. Empty if there is none, or for
/// other files. `file_bytes`: its size. Source: "OpenEXR File Layout", openexr.com.
std::string exr_header_complaint(const std::string& path, std::uint64_t file_bytes);

}  // namespace ajar
