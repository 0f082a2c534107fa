#pragma once
#include <string_view>

#include "path/path.h"
#include "transport/path_sampler.h"

namespace ajar {

/// Whether `path` is what the sampler's contribution was made of: each vertex is where its edges
/// say, specular events mirror and refract as they must, and f / p by the definitions (measure.h)
/// is the contribution without its MIS weight, its count and what is owed to chance alone. Raises
/// std::logic_error that names the first mismatch.
void verify(const Scene& scene, const PathSamplerSettings& settings, const Path& path,
            const Contribution& contribution);

/// The same of a path of which nothing is known but who made it: it has a segment for each edge,
/// its specular events mirror and refract as they must, and it lands on the film where the camera
/// sees it. Positions are rounded, and ends of manifold walks are tolerated. Raises
/// std::logic_error.
void verify(const Scene& scene, const Path& path, std::string_view made_by);

}  // namespace ajar
