#pragma once
#include <memory>

#include "image/picture.h"
#include "post/denoise/denoiser.h"

namespace ajar {

/// Adds the layers of a filter (`PictureFilter`) to a picture that was rendered before, in the
/// place of those it has. What is known of the scene is in its layers "denoising-albedo" and
/// "denoising-normal" or else "albedo" and "normal"; of its noise, in "replicates.0" and so on.
/// False, and no layers, if `progress` ended it.
bool denoise_picture(Picture& picture, std::shared_ptr<const Denoiser> denoiser,
                     const Denoiser::Progress& progress);

/// Whether a picture knows what a filter wants to know of the scene.
bool has_features(const Picture& picture);

}  // namespace ajar
