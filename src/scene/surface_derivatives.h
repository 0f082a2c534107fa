#pragma once
#include "core/vector.h"
#include "scene/shape/placement.h"

namespace ajar {

/// How a surface and its shading normal go on around a point, to first order, by two parameters
/// (u, v) that mean nothing else. World space, double precision. Asked for at points that rays have
/// met (`Scene::derivatives`), not made for every hit.
struct SurfaceDerivatives {
  Vec3d n;  ///< unit shading normal
  Vec3d dpdu, dpdv;
  Vec3d dndu, dndv;  ///< of the unit normal: perpendicular to `n`

  bool operator==(const SurfaceDerivatives&) const = default;
};

/// The same of a surface that is placed.
SurfaceDerivatives placed(const SurfaceDerivatives& surface, const Placement& placement);

/// False if the surface has no tangent plane there, or something is no number.
bool is_usable(const SurfaceDerivatives& surface);

}  // namespace ajar
