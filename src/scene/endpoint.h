#pragma once
#include <cstdint>
#include <limits>
#include <optional>

#include "core/pdf.h"
#include "core/spectrum.h"
#include "core/vector.h"
#include "scene/surface_point.h"

namespace ajar {

/// An end of a path: a point on a light or on the lens. Made by the endpoint itself
/// (`sample_emission`, `sample_connection`, `Light::at_direction`) or, on surfaces, from a ray's
/// hit; it is passed back to that endpoint unchanged.
struct EndpointPoint {
  /// p, ng, uv. Endpoints without a surface (pinhole, point light, infinity) have ng = 0. At
  /// infinity p is meaningless, except for orthographic cameras: where the ray crosses the film
  /// plane. `uv` belongs to the endpoint: environment lights keep the position in their map in it,
  /// lenses that on the lens.
  SurfacePoint surface;
  /// At infinity: unit direction from the scene to the endpoint. Else zero.
  Vec3 toward;

  /// A point that is on no surface. Everything but p is zero.
  static EndpointPoint at(const Vec3& p) {
    const Vec3 zero(0.F);
    return {{p, zero, zero, Vec2(0.F), zero, zero, zero, zero, 0}, zero};
  }
  /// A direction at infinity; `uv` as above.
  static EndpointPoint at_infinity(const Vec3& toward, const Vec2& uv = Vec2(0.F)) {
    EndpointPoint point = at(Vec3(0.F));
    point.surface.uv = uv;
    point.toward = toward;
    return point;
  }
};

/// Uniform numbers an endpoint consumes when it emits a ray.
struct EmissionUniforms {
  float primitive;
  Vec2 position;
  Vec2 direction;
};

/// Uniform numbers an endpoint consumes when it is chosen from a point of the scene.
struct ConnectionUniforms {
  float primitive;
  Vec2 position;
};

/// A ray leaving an endpoint (light: photon; camera: camera ray).
struct EmissionSample {
  EndpointPoint point;
  /// Where to start tracing: the point itself; for lights at infinity outside of the scene's
  /// bounding sphere.
  Vec3 origin;
  Vec3 w;  ///< unit direction of travel, away from the endpoint
  /// Emitted radiance (or importance) · |cos θ at a surface endpoint| / (position pdf · departure
  /// pdf).
  Spectrum weight;
  Pdf<VertexMeasure> position_pdf;
  Pdf<Departure> departure_pdf;
};

struct EmissionPdf {
  Pdf<VertexMeasure> position;
  Pdf<Departure> departure;
};

/// An endpoint seen from a point of the scene (light: next event; camera: light tracing).
struct ConnectionSample {
  EndpointPoint point;
  Vec3 w;  ///< unit, from the reference to the endpoint
  /// Infinity for lights at infinity; for orthographic cameras the distance to the film plane,
  /// which is as far as the view must be clear.
  float distance;
  /// Emitted radiance (importance) toward the reference · G / pdf without the cosine at the
  /// reference: G = |cos θ at the endpoint| / d² for surfaces, 1/d² for points, 1 at infinity.
  Spectrum weight;
  Pdf<VertexMeasure> pdf;  ///< density of the endpoint, given the reference
};

/// Common interface of lights and cameras, so that subpaths from either end are the same code.
/// Immutable, thread-safe; nothing random in it.
class Endpoint {
 public:
  virtual ~Endpoint() = default;

  /// True for environment and distant lights and orthographic cameras: the endpoint vertex is a
  /// direction, and its VertexMeasure is solid angle (or discrete).
  virtual bool at_infinity() const = 0;
  /// True if its vertex has a counting measure (point light, pinhole, distant light, orthographic
  /// camera without lens): rays never run into it.
  virtual bool discrete_position() const = 0;
  /// A ray from the endpoint. Empty if the sampled ray carries nothing: that counts as a zero, it
  /// is not to be tried again.
  virtual std::optional<EmissionSample> sample_emission(const EmissionUniforms& u) const = 0;
  /// Densities with which `sample_emission` gives this vertex and this direction of travel.
  virtual EmissionPdf emission_pdf(const EndpointPoint& point, const Vec3& w) const = 0;
  /// The numbers by which `sample_emission` gives this vertex and the ray along `w` through the
  /// point `through`. Undetermined numbers are taken from `fresh` (docs/methods/inverses.md);
  /// the density of the numbers is that of `emission_pdf`. Empty if it never does.
  virtual std::optional<EmissionUniforms> invert_emission(const EndpointPoint& point,
                                                          const Vec3& through, const Vec3& w,
                                                          const EmissionUniforms& fresh) const = 0;
  /// Emitted radiance (importance) at `point` in direction `w` away from it; no cosine. Discrete
  /// endpoints: intensity (point light, pinhole) or irradiance on the plane perpendicular to `w`
  /// (distant light). At infinity `w` is −toward.
  virtual Spectrum emitted(const EndpointPoint& point, const Vec3& w) const = 0;
  /// Samples the endpoint as seen from `reference`. Empty if it cannot reach there.
  virtual std::optional<ConnectionSample> sample_connection(const Vec3& reference,
                                                            const ConnectionUniforms& u) const = 0;
  virtual Pdf<VertexMeasure> connection_pdf(const Vec3& reference,
                                            const EndpointPoint& point) const = 0;
  /// The numbers by which `sample_connection` gives this vertex, likewise.
  virtual std::optional<ConnectionUniforms> invert_connection(
      const Vec3& reference, const EndpointPoint& point, const ConnectionUniforms& fresh) const = 0;
};

}  // namespace ajar
