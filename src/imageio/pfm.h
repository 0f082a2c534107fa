#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "imageio/image_file.h"

/// Portable float maps, which OpenImageIO 2.4 does not know. Source: P. Debevec's description of
/// the format.
namespace ajar {

/// The file's bytes: 3 channels, little-endian, rows from the bottom.
std::vector<std::byte> encode_pfm(int width, int height, std::span<const float> rgb);

/// Reads colour (PF) and grey (Pf) maps of either byte order. Raises IoError.
Image read_pfm(const std::string& path);

}  // namespace ajar
