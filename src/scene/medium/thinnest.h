#pragma once

namespace ajar {

/// Density in place of vacuum at vertices, relative to the largest density: densities of paths are
/// divided by it.
inline constexpr float kThinnest = 1e-12F;

}  // namespace ajar
