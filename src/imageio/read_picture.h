#pragma once
#include <string>

#include "imageio/picture.h"

namespace ajar {

/// A scene-linear picture with all its layers from a file: those of 3 channels, and single ones.
/// Raises IoError if the file cannot be read, has no RGB or grey picture in it, or holds display
/// values.
Picture read_picture(const std::string& path);

}  // namespace ajar
