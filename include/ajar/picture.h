#pragma once
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "ajar/namespace.h"

namespace ajar::AJAR_INTERFACE {
/// Display transform of a picture.
struct Display {
  float exposure = 0.F;           ///< stops: twice as bright for each
  std::string tone_map = "srgb";  ///< or "filmic"
};

/// A picture with all its layers. Copies share their pixels, which never change.
class Picture {
 public:
  // Size in pixels: the whole picture, or the crop window.
  int width() const;
  int height() const;

  /// "" is the picture itself, always the first.
  std::vector<std::string> layers() const;
  /// 3 (scene-linear RGB, Rec. 709), or 1. Raises Error for a layer that is not there.
  int channels(const std::string& layer = "") const;
  /// Row by row from the top, channels interleaved; valid as long as some copy of the picture is.
  /// Raises Error for a layer that is not there.
  std::span<const float> pixels(const std::string& layer = "") const;
  /// Metadata of its files: method, parameters, seed, samples, time, ….
  const std::map<std::string, std::string>& metadata() const;

  /// Writes `.exr` (all layers), `.pfm`, `.hdr` (the picture, scene-linear), `.png` or `.jpg` (as
  /// displayed), in one step: what was there before is replaced by a whole file only. Raises
  /// Error.
  void save(const std::string& path, const Display& display = {}) const;

  struct Content;
  /// For the library itself.
  explicit Picture(std::shared_ptr<const Content> content);

 private:
  std::shared_ptr<const Content> content_;
};
}  // namespace ajar::AJAR_INTERFACE
