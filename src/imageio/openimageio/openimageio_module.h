#pragma once
#include <memory>
#include <string>

#include "imageio/image_decoder.h"

namespace ajar {

/// Opens an image by OpenImageIO, of which a library of its own (`module/`) is loaded when the
/// first image asks for it: OpenImageIO brings more than 200 others, and loading them takes longer
/// than all else that a program does before it renders.
///
/// That library is looked for beside the program (or the library) that this is a part of, then in
/// ../lib/ajar from there, then where the system and the program's own run path say. Empty if it is
/// nowhere. Raises IoError with the reason, and what OpenImageIO raises.
std::unique_ptr<ImageDecoder> open_with_openimageio(const std::string& path,
                                                    bool has_unassociated_alpha);

}  // namespace ajar
