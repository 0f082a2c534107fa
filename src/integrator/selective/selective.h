#pragma once
#include <memory>

#include "integrator/integrator.h"

namespace ajar {

/// Ordinary Monte Carlo where it works, Markov chains where it fails (docs/methods/selective.md). A
/// sample per pixel is a camera sample, and as many mutations as their part of the light deserves.
/// `parameters`: `SelectiveConfig::parameters`. Raises UsageError for parameters that cannot be
/// used, SceneError or IoError for `regions`.
std::unique_ptr<Integrator> make_selective_integrator(const Scene& scene,
                                                      const RenderSettings& settings,
                                                      const Parameters& parameters);

}  // namespace ajar
