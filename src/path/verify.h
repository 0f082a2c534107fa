#pragma once
#include <string_view>

#include "path/path.h"
#include "transport/path_sampler.h"

namespace ajar {

/// Checks that `path` has the sampler's contribution: each vertex is where its edges say, specular
/// events mirror and refract as they must, and f / p by the definitions (measure.h) is the
/// contribution without its MIS weight, its count and its roulette weight. Raises std::logic_error
/// that names the first mismatch.
void verify(const Scene& scene, const PathSamplerSettings& settings, const Path& path,
            const Contribution& contribution);

/// Checks a path of unknown contribution: it has a segment for each edge, its specular events
/// mirror and refract as they must, and it lands on the film where the camera sees it. Positions
/// are rounded, and ends of manifold walks are tolerated. Raises std::logic_error.
void verify(const Scene& scene, const Path& path, std::string_view made_by);

}  // namespace ajar
