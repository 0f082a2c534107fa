#pragma once
#include <span>

#include "path/specular_chain.h"

namespace ajar {

/// ln of the density of the chain between the vertices `fixed` and `moved` > `fixed` + 1 of a path,
/// given both, and the offset normals of rough vertices between them: Π |cos θ| / d² of its edges
/// over the chain's generalised geometric term (docs/methods/mlt.md, "Chains that follow").
/// `offsets`: of all of them, from `moved` on; none if they are specular. −∞ if the chain is
/// singular, or cannot hold its constraints.
double log_chain_density(const Scene& scene, const Path& path, int fixed, int moved,
                         std::span<const OffsetNormal> offsets = {});

}  // namespace ajar
