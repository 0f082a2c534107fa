#include "post/display.h"

#include <algorithm>

#include "post/antialias.h"

namespace ajar {

Picture displayed(const Picture& picture, const DisplayOptions& options) {
  const std::vector<float>& linear = shown_layer(picture).pixels;
  std::vector<float> shown(linear.size());
  std::transform(linear.begin(), linear.end(), shown.begin(),
                 [&](float value) { return tone_map(value, options.tone_map, options.exposure); });
  if (picture.antialias_mask) {
    shown = antialias(picture.crop.size() + Vec2i(1, 1), shown, *picture.antialias_mask);
  }
  Picture result;
  result.resolution = picture.resolution;
  result.crop = picture.crop;
  result.metadata = picture.metadata;
  result.layers.push_back({"", 3, std::move(shown)});
  return result;
}

}  // namespace ajar
