#pragma once
#include <map>
#include <string>
#include <vector>

#include "core/vector.h"
#include "imageio/picture.h"

namespace ajar {

/// Pixels read from a file: row by row from the top, channels interleaved.
struct Image {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<std::string> names;  ///< names of the channels, e.g. "R", "G", "B", "albedo.R"
  std::vector<float> data;
  Vec2i origin{0, 0};      ///< full-image coordinates of the first pixel (EXR data window)
  Vec2i resolution{0, 0};  ///< size of the full image (EXR display window)
  /// 8- or 16-bit files: values are display-encoded (integer / maximum), not linear.
  bool is_display_encoded = false;
  /// Ajar's metadata of the render (`to_metadata`), names without their "ajar:".
  std::map<std::string, std::string> metadata;

  float at(int x, int y, int channel) const;
  /// The channels `R, G, B` (layer "") or `layer.R, layer.G, layer.B`, interleaved; or the only
  /// channel `layer` (or `layer.Y`, `layer.Z`), three times. An image without R, G and B gives what
  /// else is its picture (`ColorChannels`). Empty if there is no such layer, or no telling which.
  std::vector<float> rgb(const std::string& layer = "") const;
};

/// Reads any image that `ImageInput` can open, and PFM. Raises IoError.
Image read_image(const std::string& path);

/// Raises UsageError, listing the formats we write, if the extension is not one of them. To be
/// called before a long render.
void check_image_extension(const std::string& path);

/// True for names of files with display values: `.png`, `.jpg`, `.jpeg`.
bool is_display_file(const std::string& path);

/// Writes `.exr` (scene-linear, all layers), `.pfm`, `.hdr` (scene-linear, first layer), `.png`,
/// `.jpg`, `.jpeg` (8 bits for a display: values in [0, 1] of the first layer, encoded as they are
/// shown; `displayed` in post/display.h makes them), atomically (`write_file_atomically`). Metadata
/// goes where the format has room for it. In EXR, a layer of 3 channels is `name.R, name.G, name.B`
/// (just R, G, B for the layer ""), one of a single channel `name`; other formats hold the first
/// layer only, which must have 3 channels. Values that are not numbers are kept in EXR and PFM and
/// become zero elsewhere. Raises UsageError for the extension and IoError for the file.
void write_image(const std::string& path, const Picture& picture);

}  // namespace ajar
