#pragma once
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "image/film.h"
#include "integrator/integrator.h"
#include "scene/scene.h"
#include "transport/path_sampler.h"

namespace ajar::test {

/// Builds a scene from pbrt-v3 text; a warning fails the test unless it `may_warn`.
std::unique_ptr<Scene> scene_from(const std::string& pbrt_text, bool may_warn = false);

/// A scene that comes with the program, at 96×72 pixels.
Scene builtin_scene(const std::string& name);

/// Full text of a small scene: camera and film of `width` × `height` pixels, then `world`.
std::string pbrt_scene(const std::string& camera, int width, int height, const std::string& world,
                       const std::string& filter = "PixelFilter \"box\"");

/// Renders with an integrator of the registry; `samples` per pixel.
struct Render {
  std::unique_ptr<Film> film;
  std::unique_ptr<Integrator> integrator;
  std::uint64_t samples;
  Counters counters;
  /// One layer with its parts, 3 floats per pixel.
  std::vector<float> layer(const std::string& name,
                           std::optional<int> replicate = std::nullopt) const;
  /// direct + indirect.
  std::vector<float> image() const;
  std::vector<float> replicate(int index) const;
  double mean() const;  ///< over pixels and channels
};
struct RenderOptions {
  std::string integrator = "pt";
  int samples = 16;
  int replicates = 8;
  std::uint64_t seed = 1;
  int min_depth = 1;
  int max_depth = 100;
  std::map<std::string, std::string> parameters{};
  std::optional<Box2i> crop{};
  std::vector<std::string> aovs{};
  bool for_filters = false;
  std::optional<int> skip_after{};  ///< skip after so many rounds of the preparation
};
RenderSettings settings_of(const Scene& scene, const RenderOptions& options);
Render render(const Scene& scene, const RenderOptions& options);
/// With an integrator of `settings_of(scene, options)` that is prepared. At each milestone but the
/// end, `after_pass` receives the film and the samples that are on it.
using AfterPass = std::function<void(const Film& film, std::uint64_t samples)>;
Render render_with(std::unique_ptr<Integrator> integrator, const Scene& scene,
                   const RenderOptions& options, const AfterPass& after_pass = {});

}  // namespace ajar::test
