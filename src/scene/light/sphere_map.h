#pragma once
#include "core/distribution.h"
#include "core/pdf.h"
#include "core/spectrum.h"
#include "core/vector.h"
#include "scene/light/map.h"
#include "scene/light/sphere_projection.h"

namespace ajar {

/// A map over all directions. Sampled by luminance times solid angle.
class SphereMap {
 public:
  struct Sample {
    Vec2 uv;
    Vec3 w;               ///< unit
    Pdf<SolidAngle> pdf;  ///< zero where there is no solid angle, as at the pole of a latitude map
  };
  /// `map` should be made with the edge and the filter of the projection.
  SphereMap(Map map, const SphereProjection& projection);

  Vec2 to_uv(const Vec3& w) const { return projection_.to_uv(w); }
  Spectrum lookup(const Vec2& uv) const { return map_.lookup(uv); }
  Sample sample(const Vec2& u) const;
  Pdf<SolidAngle> pdf(const Vec2& uv) const;
  /// The numbers by which `sample` gives `uv`, where the density is > 0.
  Vec2 invert(const Vec2& uv) const { return distribution_.invert(uv); }
  /// Integral over the sphere, by one or more points per half texel.
  const Spectrum& integral() const { return integral_; }
  /// Integral over the half around +z, weighted by the cosine to it.
  Spectrum irradiance() const;

 private:
  Map map_;
  SphereProjection projection_;
  Distribution2D distribution_;
  Spectrum integral_;
};

}  // namespace ajar
