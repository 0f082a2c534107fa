#pragma once
#include "image/tone_curve.h"
#include "imageio/picture.h"

namespace ajar {

/// Options for the display of a picture.
struct DisplayOptions {
  ToneMap tone_map = ToneMap::Srgb;
  float exposure = 0.F;    ///< stops
  bool has_alpha = false;  ///< the format keeps it; colours are then not multiplied by it
};

/// The picture for the eye: the first layer of a scene-linear one, of 3 channels, as values in
/// [0, 1] that are encoded as they are shown; edges are smoothed where its mask allows it
/// (post/antialias.h). Crop and metadata stay, and alpha where the options say so. Values that
/// are not numbers become 0.
Picture displayed(const Picture& picture, const DisplayOptions& options);

}  // namespace ajar
