#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/vector.h"
#include "image/statistics.h"

namespace ajar::study {

/// A picture from a file, as comparisons take it. All pixels row by row from the top, RGB
/// interleaved.
struct LoadedPicture {
  std::string path;
  Vec2i size{0, 0};
  std::optional<Vec2i> origin;      ///< place of its pixels in the whole picture; stored by EXR
                                    ///< only
  std::vector<float> linear;        ///< scene-linear; display values are decoded by sRGB
  std::vector<float> display;       ///< exposure 0, sRGB, clamped to [0, 1] (docs/compare.md)
  std::vector<float> denoised;      ///< scene-linear, the layer of that name; may be empty
  bool is_display_encoded = false;  ///< the file has display values (PNG, JPEG)
  /// Error estimate of the file itself; both may be empty. `--aov replicates` and `--aov
  /// standard-error` write these layers.
  Replicates replicates;
  std::vector<float> standard_error;
};

/// Raises IoError for a file that cannot be read or has no RGB or grey picture in it.
LoadedPicture load_picture(const std::string& path);

/// Pixels of which a value is infinite or not a number.
struct NonFinitePixels {
  std::size_t count = 0;
  Vec2i first{0, 0};
};
NonFinitePixels find_non_finite(const LoadedPicture& picture);

}  // namespace ajar::study
