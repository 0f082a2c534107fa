#pragma once
#include <optional>

#include "path/path.h"

namespace ajar {

/// Two orthonormal tangents of a plane.
struct TangentPlane {
  Vec3d x, y;
};
/// The axis that is projected onto the plane across `n` for the first tangent: x, or y where n is
/// near x.
Vec3d axis_beside(const Vec3d& n);
/// Perpendicular to a unit vector, which alone decides them.
TangentPlane plane_across(const Vec3d& n);

/// The normal of the facet by which a rough vertex turns light from one direction of its path into
/// the other: the half vector η_a ω_a + η_b ω_b, of unit length and on the side of the shading
/// normal n (that before bumps). Given by its parts along the tangents `plane_across(n)`; n itself
/// is {0, 0}. Source: Jakob & Marschner 2012, "Manifold exploration" (offset normals of glossy
/// vertices); Kaplanyan, Hanika & Dachsbacher 2014, "The natural-constraint representation of the
/// path space".
struct OffsetNormal {
  double x = 0.0;
  double y = 0.0;
};

/// The shading normal n, before bumps.
Vec3d normal_before_bumps(const InnerVertex& vertex);

/// Unit vector of the world; empty if {x, y} is not within the unit circle.
std::optional<Vec3d> facet_normal(const InnerVertex& vertex, const OffsetNormal& offset);

/// Index of refraction on the far side of a rough surface over that on the side of `w`; 1 if light
/// is reflected. Empty if its rough lobes cross the surface without refraction.
std::optional<double> relative_index(const InnerVertex& vertex, bool transmission, const Vec3d& w);

/// By which facet a rough vertex turns `a` into `b`, unit vectors that point away from it, on sides
/// of the surface as `vertex.event` says. Empty if there is none.
std::optional<OffsetNormal> offset_normal(const InnerVertex& vertex, const Vec3d& a,
                                          const Vec3d& b);

/// Where such a facet turns `w`; empty if there is no such facet, if it reflects totally, or if the
/// way is on the wrong side of the surface.
std::optional<Vec3d> turn(const InnerVertex& vertex, bool transmission, const OffsetNormal& offset,
                          const Vec3d& w);

/// |dh / dω_b|, of {x, y} by the solid angle of `b` while `a` stays. Source: Walter et al. 2007,
/// eqs. 14 and 17, times the cosine of the offset normal to the shading normal.
double offset_change(const InnerVertex& vertex, const Vec3d& a, const Vec3d& b);

}  // namespace ajar
