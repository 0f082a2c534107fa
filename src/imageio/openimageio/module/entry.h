#pragma once
#include "imageio/image_decoder.h"

/// What `openimageio_module.cpp` calls in the library that it loads: opens the first image of a
/// file, for the caller to delete. Raises as `ajar::open_image` does.
extern "C" [[gnu::visibility("default")]] ajar::ImageDecoder* ajar_open_image_by_openimageio(
    const char* path, bool has_unassociated_alpha);
