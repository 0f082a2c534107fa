#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "ajar/namespace.h"
#include "ajar/picture.h"
#include "ajar/scene.h"
#include "ajar/settings.h"

/// Rendering from a program:
///
///     #include <ajar/render.h>
///
///     ajar::Settings settings;
///     settings.seconds = 10.0;
///     ajar::render(ajar::Scene::load("builtin:cornell"), settings).save("cornell.png");
namespace ajar::AJAR_INTERFACE {
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
  /// The picture so far; at first, a rough look of 0 samples per pixel, which has no other layers.
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
