#pragma once
#include "core/distribution.h"
#include "core/pdf.h"
#include "core/spectrum.h"
#include "core/vector.h"
#include "scene/light/map.h"

namespace ajar {

/// A map over all directions with latitude and longitude as in pbrt-v3: v = θ/π from +z, u = φ/2π
/// from +x toward +y. Sampled by luminance · sin θ.
class LatLongMap {
 public:
  struct Sample {
    Vec2 uv;
    Vec3 w;               ///< unit
    Pdf<SolidAngle> pdf;  ///< zero at a pole, where there is no solid angle
  };
  /// `map` should be made with MapEdge::Repeat.
  explicit LatLongMap(Map map);

  static Vec2 to_uv(const Vec3& w);
  static Vec3 to_direction(const Vec2& uv);

  Spectrum lookup(const Vec2& uv) const { return map_.lookup(uv); }
  Sample sample(const Vec2& u) const;
  Pdf<SolidAngle> pdf(const Vec2& uv) const;
  /// The numbers by which `sample` gives `uv`, where the density is > 0.
  Vec2 invert(const Vec2& uv) const { return distribution_.invert(uv); }
  /// Integral over the sphere, by one or more points per half texel.
  const Spectrum& integral() const { return integral_; }

 private:
  Map map_;
  Distribution2D distribution_;
  Spectrum integral_;
};

}  // namespace ajar
