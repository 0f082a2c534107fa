#include "post/display.h"

#include <algorithm>

#include "post/antialias.h"

namespace ajar {

Picture displayed(const Picture& picture, const DisplayOptions& options) {
  std::vector<float> shown = shown_layer(picture).pixels;
  const Picture::Layer* const alpha = options.has_alpha ? alpha_of(picture) : nullptr;
  if (alpha != nullptr) {
    // Formats for the eye have colours that are not multiplied by it.
    for (std::size_t i = 0; i < shown.size(); ++i) {
      const float opacity = alpha->pixels[i / 3];
      shown[i] = opacity > 0.F ? shown[i] / opacity : 0.F;
    }
  }
  std::transform(shown.begin(), shown.end(), shown.begin(),
                 [&](float value) { return tone_map(value, options.tone_map, options.exposure); });
  if (picture.antialias_mask) {
    shown = antialias(picture.crop.size() + Vec2i(1, 1), shown, *picture.antialias_mask);
  }
  Picture result;
  result.resolution = picture.resolution;
  result.crop = picture.crop;
  result.metadata = picture.metadata;
  result.layers.push_back({"", 3, std::move(shown)});
  if (alpha != nullptr) result.layers.push_back(*alpha);
  return result;
}

}  // namespace ajar
