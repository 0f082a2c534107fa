#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ajar/namespace.h"

namespace ajar::AJAR_INTERFACE {
/// Settings of a render. Empty ones are taken from the scene, or else are the defaults of `ajar
/// render`. Numbers have its bounds, too.
struct Settings {
  std::string integrator;                         ///< a name of `integrators()`
  std::map<std::string, std::string> parameters;  ///< parameters of the integrator
  // The render ends at whichever comes first; with none, after 64 samples per pixel.
  std::optional<std::uint64_t> samples_per_pixel;
  std::optional<double> seconds;       ///< wall clock, up to the finished picture but for loading
  std::optional<double> target_error;  ///< relative error of the picture, as estimated
  bool denoised_target = false;        ///< ... of the denoised picture
  std::optional<std::array<int, 2>> resolution;  ///< width and height, pixels
  std::optional<double> scale;                   ///< factor of the scene's size, instead
  // Edges of the paths: 1 is light seen directly, 2 is direct lighting.
  std::optional<int> min_depth;
  std::optional<int> max_depth;
  /// Pixels to be rendered, from the top left: x0, y0, x1, y1; the last two are beyond the window.
  std::optional<std::array<int, 4>> crop;
  std::string filter;               ///< NAME or NAME:RADIUS, as of `ajar render --filter`
  std::vector<std::string> layers;  ///< beside the picture; see `ajar list aovs`
  /// Takes the noise out of pictures: auto, oidn, builtin or none, as `ajar render --denoise`. They
  /// have the layer "denoised" then, which `Picture::save` shows in formats for the eye.
  std::string denoise = "none";
  std::uint64_t seed = 0;
  int threads = 0;         ///< 0: as many as the machine offers; else a limit for the whole process
  std::string checkpoint;  ///< a file with all that is needed to go on; none if empty
  double checkpoint_every = 60.0;  ///< seconds
  /// Goes on with `checkpoint`, which must be of the same render, if the file is there.
  bool resume = false;
};
}  // namespace ajar::AJAR_INTERFACE
