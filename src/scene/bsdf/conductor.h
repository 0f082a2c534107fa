#pragma once
#include "scene/bsdf/microfacet_reflection.h"

namespace ajar {

/// Rough metal. (pbrt-v3 has no perfectly smooth metal: α is never below `Microfacets::kMinAlpha`.)
using Conductor = MicrofacetReflection<ConductorFresnel>;

}  // namespace ajar
