#pragma once
#include <optional>

#include "path/path.h"
#include "transport/path_sampler.h"

namespace ajar {

/// The path that the technique of a `PathSampler` finds by these numbers, at `raster`; by the first
/// light subpath, in the first try. Empty if it finds none.
std::optional<Path> replay(const Scene& scene, const PathSamplerSettings& settings,
                           SampleSource& numbers, const Vec2& raster, Technique technique);

}  // namespace ajar
