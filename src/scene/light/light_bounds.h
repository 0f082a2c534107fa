#pragma once
#include <algorithm>

#include "scene/direction_cone.h"

namespace ajar {

/// Bounds of a light at a finite place for a light tree: position, directions and power. Light only
/// leaves it in directions within `emission_angle` of one of `normals` (or of its negative).
/// Source: Conty Estevez & Kulla 2018, section 4.1.
struct LightBounds {
  Box3 box;
  DirectionCone normals;
  float emission_angle = 0.F;  ///< radians, up to π/2; irrelevant for the whole sphere of normals
  /// Largest radiant intensity in any direction, approximately: luminance, W/sr. Intensity rather
  /// than power, so that a narrow beam has its weight for points within.
  float intensity = 0.F;
  bool two_sided = false;
};

/// Bounds of both together; their intensities add up.
inline LightBounds unite(const LightBounds& a, const LightBounds& b) {
  LightBounds both = a;
  both.box.extendBy(b.box);
  both.normals = unite(a.normals, b.normals);
  both.emission_angle = std::max(a.emission_angle, b.emission_angle);
  both.intensity = a.intensity + b.intensity;
  both.two_sided = a.two_sided || b.two_sided;
  return both;
}

/// Bounds of a light at one point with any distribution of directions and mean intensity
/// `intensity`.
inline LightBounds point_bounds(const Vec3& position, float intensity) {
  return {Box3(position), DirectionCone::whole_sphere(), 0.5F * kPi, intensity, false};
}

}  // namespace ajar
