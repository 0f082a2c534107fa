#include "scene/surface_derivatives.h"

#include <cmath>

namespace ajar {

SurfaceDerivatives placed(const SurfaceDerivatives& surface, const Placement& placement) {
  const Vec3d moved = placement.normal(surface.n);
  const double size = moved.length();
  const Vec3d n = moved / size;
  const auto normal_derivative = [&](const Vec3d& dn) {
    const Vec3d change = placement.normal(dn) / size;
    return change - n * n.dot(change);
  };
  return {n, placement.vector(surface.dpdu), placement.vector(surface.dpdv),
          normal_derivative(surface.dndu), normal_derivative(surface.dndv)};
}

bool is_usable(const SurfaceDerivatives& surface) {
  const Vec3d area = surface.dpdu.cross(surface.dpdv);
  const double sum =
      surface.n.dot(surface.n) + surface.dndu.dot(surface.dndu) + surface.dndv.dot(surface.dndv);
  return area.dot(area) > 0.0 && std::isfinite(area.dot(area)) && std::isfinite(sum);
}

}  // namespace ajar
