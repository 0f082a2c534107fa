#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include "imageio/picture.h"
#include "post/denoise/denoiser.h"

namespace ajar {

/// Adds the layers of a filter (`PictureFilter`) to a picture that was rendered before, in the
/// place of those it has. What is known of the scene is in its layers "denoising-albedo" and
/// "denoising-normal" or else "albedo" and "normal"; of its noise, in "replicates.0" and so on.
/// False, and no layers, if `progress` ended it.
bool denoise_picture(Picture& picture, std::shared_ptr<const Denoiser> denoiser,
                     const Denoiser::Progress& progress);

/// Memory that this takes beside the picture, until it is written, bytes; an estimate.
std::uint64_t denoising_bytes(const Picture& picture, const Denoiser& denoiser);

/// The filter, if `available` bytes (0: nobody knows) are enough for it; else, if `may_be_another`,
/// the built-in one, if they are for that, with a `note` that says so. Raises UsageError with what
/// is needed.
std::shared_ptr<const Denoiser> fitting_denoiser(const Picture& picture,
                                                 std::shared_ptr<const Denoiser> wanted,
                                                 bool may_be_another, std::uint64_t available,
                                                 std::string& note);

/// True if a picture has the auxiliary buffers of denoisers.
bool has_features(const Picture& picture);

}  // namespace ajar
