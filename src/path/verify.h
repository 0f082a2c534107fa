#pragma once
#include "path/path.h"
#include "transport/path_sampler.h"

namespace ajar {

/// Whether `path` is what the sampler's contribution was made of: each vertex is where its edges
/// say, specular events mirror and refract as they must, and f / p by the definitions (measure.h)
/// is the contribution without its MIS weight, its count and what is owed to chance alone. Raises
/// std::logic_error that names the first mismatch.
void verify(const Scene& scene, const PathSamplerSettings& settings, const Path& path,
            const Contribution& contribution);

}  // namespace ajar
