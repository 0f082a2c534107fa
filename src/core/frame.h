#pragma once
#include "core/vector.h"

namespace ajar {

/// Right-handed orthonormal frame; `z` is usually a shading normal. All axes have unit length.
struct Frame {
  Vec3 x{1.F, 0.F, 0.F};
  Vec3 y{0.F, 1.F, 0.F};
  Vec3 z{0.F, 0.F, 1.F};

  /// Any frame around unit vector `n`, continuous but for one pole.
  /// Source: Duff et al. 2017, "Building an orthonormal basis, revisited".
  static Frame around(const Vec3& n) {
    const float sign = std::copysign(1.F, n.z);
    const float a = -1.F / (sign + n.z);
    const float b = n.x * n.y * a;
    return {
        {1.F + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
  }
  /// Frame around `n` whose x axis is the part of `tangent` perpendicular to n; falls back to
  /// `around` if there is none.
  static Frame around(const Vec3& n, const Vec3& tangent) {
    const Vec3 x = tangent - n * dot(n, tangent);
    const float squared = length_squared(x);
    if (!(squared > 1e-12F * length_squared(tangent)) || !std::isfinite(squared)) return around(n);
    const Vec3 unit = x / std::sqrt(squared);
    return {unit, cross(n, unit), n};
  }

  Vec3 to_local(const Vec3& v) const { return {dot(v, x), dot(v, y), dot(v, z)}; }
  Vec3 to_world(const Vec3& v) const { return x * v.x + y * v.y + z * v.z; }
};

}  // namespace ajar
