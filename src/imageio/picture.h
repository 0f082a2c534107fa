#pragma once
#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/plane.h"
#include "core/vector.h"

namespace ajar {

/// A developed picture with all its layers: what goes into files. It holds its pixels itself, so
/// that whoever writes or shows it cannot outlive them.
struct Picture {
  struct Layer {
    std::string name;           ///< "" for the picture itself
    int channels = 3;           ///< 3, or 1
    std::vector<float> pixels;  ///< scene-linear unless said otherwise, row by row, crop only,
                                ///< channels interleaved
  };
  Vec2i resolution{0, 0};     ///< size of the full image
  Box2i crop;                 ///< inclusive; the pixels that exist
  std::vector<Layer> layers;  ///< the first is the picture
  std::map<std::string, std::string> metadata;
  /// The picture for filters of noise: with splats as a filter of one pixel's box has them; empty
  /// where that is the picture itself. Not in files.
  std::vector<float> for_filters{};
  /// Where formats for the eye smooth the stairs of edges (post/antialias.h); empty if nowhere.
  std::optional<Plane> antialias_mask{};
};

/// The layer of one channel that programs which show pictures take for how opaque they are.
inline constexpr const char* kAlphaLayer = "A";

/// The layer without noise, where there is one.
inline constexpr const char* kDenoisedLayer = "denoised";

/// The layer of this name; null if there is none.
inline const Picture::Layer* layer_named(const Picture& picture, const std::string& name) {
  const auto found = std::find_if(picture.layers.begin(), picture.layers.end(),
                                  [&](const Picture::Layer& layer) { return layer.name == name; });
  return found == picture.layers.end() ? nullptr : &*found;
}

/// Alpha of its pixels; null if unknown. (A layer of colours may have that name.)
inline const Picture::Layer* alpha_of(const Picture& picture) {
  const auto found =
      std::find_if(picture.layers.begin(), picture.layers.end(), [&](const Picture::Layer& layer) {
        return layer.name == kAlphaLayer && layer.channels == 1;
      });
  return found == picture.layers.end() ? nullptr : &*found;
}

/// Displayed layer of a picture: the denoised one or, if there is none, the picture itself.
inline const Picture::Layer& shown_layer(const Picture& picture) {
  const Picture::Layer* const denoised = layer_named(picture, kDenoisedLayer);
  return denoised == nullptr ? picture.layers.front() : *denoised;
}

}  // namespace ajar
