#pragma once
#include <cassert>
#include <cmath>

#include "core/vector.h"

namespace ajar {

/// Measures that a density can refer to; they exist only as types.
struct Area {};        ///< surface area, 1/m²
struct SolidAngle {};  ///< solid angle, 1/sr
struct Discrete {};    ///< counting measure: a probability
/// The measure a path vertex lives in: area on surfaces and lenses, volume inside media, solid
/// angle for vertices at infinity, counting measure for point lights and pinholes.
struct VertexMeasure {};
/// Second coordinate of a ray that leaves an endpoint: solid angle for endpoints at a finite place,
/// area on the plane perpendicular to the ray for endpoints at infinity, counting measure if the
/// direction (or that point) is fixed.
struct Departure {};

/// A probability density whose measure is part of its type, so that densities with respect to
/// different measures cannot be mixed by accident. Zero means "cannot be sampled", nothing else:
/// whether a distribution is discrete is said by types and flags, never by the value.
template <typename Measure>
class Pdf {
 public:
  constexpr Pdf() = default;
  constexpr explicit Pdf(float value) : value_(value) {}
  constexpr float value() const { return value_; }
  constexpr Pdf operator*(float probability) const { return Pdf(value_ * probability); }
  constexpr bool operator==(const Pdf&) const = default;

 private:
  float value_ = 0.F;
};

/// Density of the direction chosen at a scattering event: a solid-angle density for ordinary lobes,
/// a probability for perfectly specular ones.
class DirectionPdf {
 public:
  constexpr DirectionPdf() = default;
  constexpr explicit DirectionPdf(Pdf<SolidAngle> density) : value_(density.value()) {}
  constexpr explicit DirectionPdf(Pdf<Discrete> probability)
      : value_(probability.value()), discrete_(true) {}
  constexpr bool discrete() const { return discrete_; }
  constexpr Pdf<SolidAngle> density() const {
    assert(!discrete_);
    return Pdf<SolidAngle>(value_);
  }
  constexpr Pdf<Discrete> probability() const {
    assert(discrete_);
    return Pdf<Discrete>(value_);
  }
  /// The number itself: what remains of a ratio of two such densities when the Dirac deltas cancel.
  constexpr float value() const { return value_; }

 private:
  float value_ = 0.F;
  bool discrete_ = false;
};

/// Area density at `to` of a direction density at `from`: pdf · |cos θ_to| / d². `normal` is the
/// geometric normal at `to`. Source: Veach 1997, eq. 8.8.
inline Pdf<Area> to_area(Pdf<SolidAngle> pdf, const Vec3& from, const Vec3& to,
                         const Vec3& normal) {
  const Vec3 d = to - from;
  const float distance_squared = length_squared(d);
  if (distance_squared == 0.F) return Pdf<Area>(0.F);
  return Pdf<Area>(pdf.value() * abs_dot(d, normal) /
                   (distance_squared * std::sqrt(distance_squared)));
}
/// The inverse of `to_area`: zero where the surface is seen edge-on.
inline Pdf<SolidAngle> to_solid_angle(Pdf<Area> pdf, const Vec3& from, const Vec3& to,
                                      const Vec3& normal) {
  const Vec3 d = to - from;
  const float distance_squared = length_squared(d);
  const float cosine_times_distance = abs_dot(d, normal);
  if (cosine_times_distance == 0.F) return Pdf<SolidAngle>(0.F);
  return Pdf<SolidAngle>(pdf.value() * distance_squared * std::sqrt(distance_squared) /
                         cosine_times_distance);
}

}  // namespace ajar
