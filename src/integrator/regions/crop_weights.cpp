#include "integrator/regions/crop_weights.h"

#include "core/error.h"
#include "imageio/image_file.h"

namespace ajar {

std::vector<float> read_crop_weights(const std::string& parameter, const std::string& path,
                                     const RenderSettings& settings) {
  const Image image = read_image(path);
  const Vec2i size = settings.crop.size() + Vec2i(1, 1);
  const bool whole = image.width == settings.resolution.x && image.height == settings.resolution.y;
  if (!whole && (image.width != size.x || image.height != size.y)) {
    throw UsageError(parameter + ": " + path + " has " + std::to_string(image.width) + "x" +
                     std::to_string(image.height) + " pixels, the picture " +
                     std::to_string(settings.resolution.x) + "x" +
                     std::to_string(settings.resolution.y));
  }
  const std::vector<float> colors = image.rgb();
  if (colors.empty()) throw UsageError(parameter + ": " + path + " has no colours");
  const Vec2i first = whole ? settings.crop.min : Vec2i(0, 0);
  std::vector<float> weights;
  weights.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  for (int y = first.y; y < first.y + size.y; ++y) {
    for (int x = first.x; x < first.x + size.x; ++x) {
      const std::size_t i =
          3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
               static_cast<std::size_t>(x));
      weights.push_back(luminance(Spectrum(colors[i], colors[i + 1], colors[i + 2])));
    }
  }
  return weights;
}

}  // namespace ajar
