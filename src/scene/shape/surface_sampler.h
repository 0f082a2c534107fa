#pragma once
#include <optional>

#include "core/pdf.h"
#include "scene/direction_cone.h"
#include "scene/surface_point.h"

namespace ajar {

struct SurfaceUniforms {
  float primitive;  ///< chooses a triangle
  Vec2 position;
};
struct SurfaceSample {
  SurfacePoint point;
  Pdf<Area> pdf;
};

/// Where a surface is and how it is turned.
struct SurfaceExtent {
  Box3 box;
  DirectionCone normals;  ///< contains `ng` of every point
};

/// Samples points on an emitting surface in world space (instanced surfaces do not emit).
/// Immutable.
class SurfaceSampler {
 public:
  virtual ~SurfaceSampler() = default;
  virtual float area() const = 0;  ///< m²
  virtual SurfaceExtent extent() const = 0;
  /// Points of it have `SurfacePoint::primitive` below that.
  virtual std::uint32_t primitives() const { return 1; }
  /// Uniform over the surface (of quadrics under transforms that are not similarities: over the
  /// surface in object space).
  virtual SurfaceSample sample(const SurfaceUniforms& u) const = 0;
  virtual Pdf<Area> pdf(const SurfacePoint& point) const = 0;
  /// Better suited for light arriving at `reference` (spheres: the visible cone). Empty if the
  /// reference sees nothing. Default: as `sample`.
  virtual std::optional<SurfaceSample> sample_toward(const Vec3& reference,
                                                     const SurfaceUniforms& u) const;
  virtual Pdf<Area> pdf_toward(const Vec3& reference, const SurfacePoint& point) const;
  /// The numbers by which `sample` and `sample_toward` give `point`; undetermined ones are taken
  /// from `fresh` (docs/methods/inverses.md). Empty if they never do.
  virtual std::optional<SurfaceUniforms> invert(const SurfacePoint& point,
                                                const SurfaceUniforms& fresh) const = 0;
  virtual std::optional<SurfaceUniforms> invert_toward(const Vec3& reference,
                                                       const SurfacePoint& point,
                                                       const SurfaceUniforms& fresh) const;
};

}  // namespace ajar
