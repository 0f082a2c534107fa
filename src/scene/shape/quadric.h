#pragma once
#include <optional>

#include "core/vector.h"
#include "scene/shape/placement.h"
#include "scene/surface_point.h"

namespace ajar {

/// Parameterisation u, v of a disk. The angle is given as its share of φ_max, the radius as its
/// share of the way from the hole to the rim.
enum class DiskCoordinates { AngleThenRadiusInward, RadiusThenAngle, AngleThenRadius };

/// A piece of a surface of revolution about z, in object space and double precision. Every point is
/// P(u, v) = R_z(u · φ_max) c(v) with a profile curve c; parameters as in Pharr et al. 2016,
/// chapter
/// 3. Disks may have them in another order.
class Quadric {
 public:
  /// Point and derivatives at some (u, v).
  struct Point {
    Vec3d p;
    Vec3d n;  ///< unit, outward of a sphere, toward +z of a disk; ∂P/∂u × ∂P/∂v or its opposite
    Vec3d dpdu, dpdv;
    Vec3d dndu, dndv;
  };
  /// Ray parameters at which a ray meets the surface, ascending.
  struct Roots {
    int count = 0;
    double t[2] = {0.0, 0.0};
  };

  /// Empty, as all below, if the shape has no area (radius or height or angle of zero) or is not
  /// finite. Pieces between `z_min` and `z_max`, in either order, up to `phi_max` (degrees).
  static std::optional<Quadric> sphere(float radius, float z_min, float z_max, float phi_max);
  static std::optional<Quadric> disk(
      float height, float radius, float inner_radius, float phi_max,
      DiskCoordinates coordinates = DiskCoordinates::AngleThenRadiusInward);
  /// `radius` is that at the upper end.
  static std::optional<Quadric> paraboloid(float radius, float z_min, float z_max, float phi_max);
  /// Surface of revolution of the line from `p1` to `p2` around z.
  static std::optional<Quadric> ruled(const Vec3& p1, const Vec3& p2, float phi_max);

  /// `direction` need not be a unit vector; roots of either sign, on the existing part only.
  Roots intersect(const Vec3d& origin, const Vec3d& direction) const;
  /// The nearest point on the surface to a point close to it (moved along the radius or axis), and
  /// its (u, v).
  Vec3d project(const Vec3d& p) const;
  /// Parameters of a point on the surface; the angle may exceed 1 where a part is cut away.
  Imath::V2d parameters(const Vec3d& p) const;
  Point at(const Imath::V2d& uv) const;

  /// Exact area in object space.
  double area() const;
  /// (u, v) such that uniform `x` in [0, 1)² gives uniform area.
  Imath::V2d uniform_parameters(const Imath::V2d& x) const;
  /// Its inverse.
  Imath::V2d uniforms_of(const Imath::V2d& uv) const;
  /// Box that contains the surface, in object space.
  void bounds(Vec3d& low, Vec3d& high) const;

  /// Set if the surface is a whole sphere.
  std::optional<double> full_sphere_radius() const;
  bool is_sphere() const { return kind_ == Kind::Sphere; }
  bool is_disk() const { return kind_ == Kind::Disk; }

 private:
  enum class Kind { Sphere, Disk, Ruled, Paraboloid };

  /// Share of φ_max and place on the profile curve, the (u, v) of all but some disks.
  struct Place {
    double turn = 0.0;
    double v = 0.0;
  };
  Place place_of(const Vec3d& p) const;
  Place place_at(const Imath::V2d& uv) const;
  Imath::V2d parameters_at(const Place& place) const;
  double uniform_v(double x) const;
  /// The share of the area between v = 0 and v.
  double area_share(double v) const;
  bool in_range(const Vec3d& p) const;
  /// Cumulative area from v = 0, per radian (ruled surfaces).
  double ruled_area(double v) const;
  Vec3d profile(double v) const;
  Vec3d profile_derivative(double v) const;
  double clamped_v(double v) const;

  Kind kind_ = Kind::Sphere;
  double phi_max_ = 0.0;
  bool full_turn_ = true;
  double radius_ = 0.0;        ///< sphere, paraboloid (at z_max): radius; disk: outer radius
  double inner_radius_ = 0.0;  ///< disk
  DiskCoordinates coordinates_ = DiskCoordinates::AngleThenRadiusInward;
  double z_min_ = 0.0;  ///< disk: its height
  double z_max_ = 0.0;
  double theta_min_ = 0.0;  ///< sphere: polar angle at v = 0
  double theta_max_ = 0.0;
  Vec3d p1_{0.0};    ///< ruled: end of the generating line at v = 0
  Vec3d edge_{0.0};  ///< ruled: from there to the end at v = 1
};

/// The point with parameters `uv` of a quadric in the world. `reversed` turns the normal around.
SurfacePoint quadric_surface_point(const Quadric& quadric, const Placement& placement,
                                   bool reversed, const Imath::V2d& uv);
/// The point `p` (in object space) of a sphere, all derivatives zero: much cheaper.
SurfacePoint sphere_plain_point(const Quadric& sphere, const Placement& placement, bool reversed,
                                const Vec3d& p);

}  // namespace ajar
