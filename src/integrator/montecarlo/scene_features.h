#pragma once
#include <functional>
#include <optional>

#include "image/features.h"
#include "integrator/integrator.h"

namespace ajar {

/// Auxiliary buffers of a scene for denoisers: camera rays are followed through mirrors and clear
/// glass, at random by Fresnel's equations, to the first surface that scatters, each pixel's mean
/// over its own square. On all threads, of the crop; by the picture's seed, whatever the integrator
/// does. Calls `progress` with the finished part, in [0, 1], from any thread; false cancels it, and
/// there is no result. `roughly`: one ray for each pixel, for previews.
std::optional<Features> trace_features(const Scene& scene, const RenderSettings& settings,
                                       const std::function<bool(double done)>& progress = {},
                                       bool roughly = false);

}  // namespace ajar
