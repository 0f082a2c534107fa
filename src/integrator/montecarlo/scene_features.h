#pragma once
#include <functional>
#include <optional>

#include "image/features.h"
#include "integrator/integrator.h"

namespace ajar {

/// Looks at a scene as filters need it: camera rays are followed through mirrors and clear glass,
/// by chance as Fresnel's equations have it, to the first surface that scatters, each pixel's mean
/// over its own square. On all threads, of the crop; by the picture's seed, whatever the integrator
/// does. Any thread tells `progress` how much is done, in [0, 1]; false ends it, and there is
/// nothing. `roughly`: with one ray for each pixel, where somebody waits.
std::optional<Features> trace_features(const Scene& scene, const RenderSettings& settings,
                                       const std::function<bool(double done)>& progress = {},
                                       bool roughly = false);

}  // namespace ajar
