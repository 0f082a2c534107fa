#pragma once
#include "core/vector.h"
#include "scene/shape/placement.h"

namespace ajar {

/// Derivatives of a surface and its shading normal by two arbitrary parameters (u, v). World space,
/// double precision. Computed on request (`Scene::derivatives`), not for every hit.
struct SurfaceDerivatives {
  Vec3d n;  ///< unit shading normal
  Vec3d dpdu, dpdv;
  Vec3d dndu, dndv;  ///< derivatives of the unit normal: perpendicular to `n`

  bool operator==(const SurfaceDerivatives&) const = default;
};

/// Derivatives of a placed surface.
SurfaceDerivatives placed(const SurfaceDerivatives& surface, const Placement& placement);

/// False if the surface has no tangent plane there, or something is no number.
bool is_usable(const SurfaceDerivatives& surface);

}  // namespace ajar
