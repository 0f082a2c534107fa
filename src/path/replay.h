#pragma once
#include <optional>

#include "path/path.h"
#include "transport/path_sampler.h"

namespace ajar {

/// The path that the technique of a `PathSampler` finds by these numbers, at `raster`; by the first
/// light subpath, in the first try. Empty if it finds none.
std::optional<Path> replay(const Scene& scene, const PathSamplerSettings& settings,
                           SampleSource& numbers, const Vec2& raster, Technique technique);

/// Replays the two halves alone, for samplers whose paths all have the technique's depth. `rays`
/// counts its rays.
std::optional<Path> replay_halves(const Scene& scene, const PathSamplerSettings& settings,
                                  SampleSource& numbers, const Vec2& raster, Technique technique,
                                  RayCounts& rays);

}  // namespace ajar
