#pragma once
#include "import/tungsten/object_reader.h"

namespace ajar::tungsten {

/// "max_bounces" of integrators that do not give it.
inline constexpr int kUsualPathBounces = 64;

/// Reads the object "integrator", which says how to render.
void read_integrator(Context& context, const LocatedJson& json);
/// Reads the object "renderer", which says how much, and where to put it.
void read_renderer(Context& context, const LocatedJson& json);

}  // namespace ajar::tungsten
