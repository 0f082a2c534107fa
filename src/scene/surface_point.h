#pragma once
#include <cstdint>

#include "core/vector.h"

namespace ajar {

/// A point on a surface with everything that textures and materials need. World space.
struct SurfacePoint {
  Vec3 p;
  Vec3 ng;  ///< unit geometric normal; its side is that of the shape's orientation, not of the ray
  Vec3 ns;  ///< unit shading normal, in the hemisphere of `ng`
  Vec2 uv;
  Vec3 dpdu;  ///< not normalised; never zero
  Vec3 dpdv;
  /// Derivatives of the shading normal, for bump mapping; zero for flat shading.
  Vec3 dndu;
  Vec3 dndv;
  std::uint32_t primitive = 0;  ///< triangle within its mesh; 0 for other shapes
};

/// `p` moved off the surface with geometric normal `ng` to the side that `w` points to, by as little as
/// float rounding of `p` demands: neither leaks nor self-shadows.
/// Source: Wächter & Binder 2019, "A fast and robust method for avoiding self-intersection".
Vec3 offset_ray_origin(const Vec3& p, const Vec3& ng, const Vec3& w);

}  // namespace ajar
