#include "study/loaded_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/error.h"
#include "image/tone_curve.h"
#include "imageio/image_file.h"
#include "imageio/picture.h"
#include "os/file_extension.h"

namespace ajar::study {

namespace {
Replicates read_replicates(const Image& image) {
  Replicates replicates;
  while (true) {
    std::vector<float> next = image.rgb(fmt::format("replicates.{}", replicates.size()));
    if (next.empty()) return replicates;
    replicates.push_back(std::move(next));
  }
}
}  // namespace

LoadedPicture load_picture(const std::string& path) {
  const Image image = read_image(path);
  LoadedPicture picture;
  picture.path = path;
  picture.size = {image.width, image.height};
  if (file_extension(path) == ".exr") picture.origin = image.origin;
  picture.is_display_encoded = image.is_display_encoded;
  picture.linear = image.rgb();
  if (picture.linear.empty()) {
    std::string names;
    for (const std::string& name : image.names) names += (names.empty() ? "" : ", ") + name;
    throw IoError("cannot use \"" + path +
                  "\": it has no channels R, G, B or Y; there are: " + names);
  }
  if (picture.is_display_encoded) {
    picture.display = picture.linear;
    for (float& value : picture.linear) value = linear_from_srgb(value);
  } else {
    picture.display = to_ldr(picture.linear);
    picture.denoised = image.rgb(kDenoisedLayer);
    picture.replicates = read_replicates(image);
    picture.standard_error = image.rgb("standard-error");
  }
  return picture;
}

NonFinitePixels find_non_finite(const LoadedPicture& picture) {
  NonFinitePixels found;
  for (std::size_t pixel = 0; 3 * pixel < picture.linear.size(); ++pixel) {
    const float* rgb = picture.linear.data() + 3 * pixel;
    if (std::isfinite(rgb[0]) && std::isfinite(rgb[1]) && std::isfinite(rgb[2])) continue;
    const auto width = static_cast<std::size_t>(picture.size.x);
    if (found.count++ == 0) {
      found.first = {static_cast<int>(pixel % width), static_cast<int>(pixel / width)};
    }
  }
  return found;
}

}  // namespace ajar::study
