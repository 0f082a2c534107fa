#pragma once
#include <cstdint>

#include "scene/surface_point.h"

namespace ajar {

class Light;
class Material;
class Medium;

/// Media on the two sides of a surface; `changes` is false if a ray keeps the medium it is in.
struct MediumInterface {
  const Medium* inside = nullptr;   ///< on the side that −ng points to
  const Medium* outside = nullptr;  ///< on the side that +ng points to
  bool changes = false;
};

/// Where a ray meets the geometry.
struct GeometryHit {
  float t;
  std::uint32_t shape;        ///< flat index of the shape, see Geometry
  std::uint32_t instance_id;  ///< 0: not an instance; else index of the instance + 1
  SurfacePoint point;
  bool cut_away = false;  ///< cut away, but counted as a surface
};

/// Intersection of a ray with the scene.
struct Hit : GeometryHit {
  const Material* material;      ///< never null
  const Light* light;            ///< null if the surface does not emit
  const MediumInterface* media;  ///< never null
  std::uint32_t object_id;       ///< number of the shape in the description, objects' shapes last
  std::uint32_t material_id;

  /// True if a ray passes straight through, and only its medium changes. Emissive surfaces are
  /// never interfaces.
  bool is_interface() const;
};

}  // namespace ajar
