#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ajar/namespace.h"
#include "ajar/picture.h"
#include "ajar/scene.h"

/// Rendering from a program:
///
///     #include <ajar/render.h>
///
///     ajar::Settings settings;
///     settings.seconds = 10.0;
///     ajar::render(ajar::Scene::load("builtin:cornell"), settings).save("cornell.png");
namespace ajar::AJAR_INTERFACE {
/// Settings of a render. Empty ones are taken from the scene, or else are the defaults of `ajar
/// render`. Numbers have its bounds, too.
struct Settings {
  std::string integrator;                         ///< a name of `integrators()`
  std::map<std::string, std::string> parameters;  ///< parameters of the integrator
  // The render ends at whichever comes first; with none, after 64 samples per pixel.
  std::optional<std::uint64_t> samples_per_pixel;
  std::optional<double> seconds;                 ///< wall clock, of all but loading
  std::optional<double> target_error;            ///< relative error of the picture, as estimated
  bool denoised_target = false;                  ///< ... of the denoised picture
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

/// Progress of a render.
struct Progress {
  bool preparing = false;
  double seconds = 0.0;                   ///< since the start of preparing, or of rendering
  double samples_per_pixel = 0.0;         ///< on average
  std::optional<double> fraction;         ///< share of the work, 0…1, as far as known
  std::optional<double> estimated_error;  ///< relative, of the picture
  bool error_is_lower_bound = true;
};

/// Callbacks during a render, on the thread of `run`; an exception from one ends the render. All
/// may be empty.
struct Callbacks {
  std::function<void(const Progress&)> progress;  ///< after each pass
  /// As it is; at first, a rough look of 0 samples per pixel, which has no other layers.
  std::function<void(const Picture&)> picture;
  double picture_every = 1.0;  ///< seconds, at least; from 0 on
  std::function<void(const std::string&)> warning;
  std::function<void(const std::string&)> note;
  /// A file that could not be written, and where it is instead, or that it will be tried again.
  /// Reported as a `warning` if this is empty.
  std::function<void(const std::string&)> trouble;
};

/// One render. `run` takes its time; meanwhile other threads may call all else.
class Render {
 public:
  /// Raises Error for settings that cannot be known.
  explicit Render(Scene scene, const Settings& settings = {}, Callbacks callbacks = {});
  ~Render();
  Render(Render&&) noexcept;
  Render& operator=(Render&&) noexcept;

  /// Renders to the end and returns the picture; to be called once. Raises Error; so, too, if it
  /// was stopped before there was a picture.
  Picture run();

  /// Ends it after the pass that runs; called twice, within it.
  void stop();
  Progress progress() const;
  /// The picture as it is: waits for the end of the pass that runs. Before the first pass, a rough
  /// look of 0 samples per pixel if the method has one, without other layers; else empty, and so in
  /// callbacks.
  std::optional<Picture> picture() const;
  /// All that is known, as JSON with the keys of `ajar render --stats`; waits likewise.
  std::string statistics() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// All in one.
Picture render(const Scene& scene, const Settings& settings = {});
}  // namespace ajar::AJAR_INTERFACE
