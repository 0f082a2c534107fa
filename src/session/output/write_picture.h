#pragma once
#include <string>

#include "post/display.h"

namespace ajar {

/// Writes a scene-linear picture as the name's extension asks: as it is, or, to a file for the eye,
/// as it is displayed. Raises what `write_image` raises.
void write_picture(const std::string& path, const Picture& picture,
                   const DisplayOptions& display = {});

}  // namespace ajar
