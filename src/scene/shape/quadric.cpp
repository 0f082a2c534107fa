#include "scene/shape/quadric.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "scene/shape/quadric_math.h"

namespace ajar {

namespace {

/// Where the surface meets its axis derivatives vanish; they are taken at this fraction of its
/// radius.
constexpr double kPole = 1e-5;

double radians(double degrees) { return degrees * (std::numbers::pi / 180.0); }
Vec3d turned(const Vec3d& v, double cos_phi, double sin_phi) {
  return {cos_phi * v.x - sin_phi * v.y, sin_phi * v.x + cos_phi * v.y, v.z};
}
double radial_dot(const Vec3d& a, const Vec3d& b) { return a.x * b.x + a.y * b.y; }
double radial_length(const Vec3d& v) { return std::hypot(v.x, v.y); }

}  // namespace

std::optional<Quadric> Quadric::sphere(float radius, float z_min, float z_max, float phi_max) {
  Quadric q;
  q.kind_ = Kind::Sphere;
  const double r = radius;
  q.radius_ = r;
  q.phi_max_ = radians(std::clamp(phi_max, 0.F, 360.F));
  q.full_turn_ = phi_max >= 360.F;
  const double a = z_min;
  const double b = z_max;
  q.z_min_ = std::clamp(std::min(a, b), -r, std::max(r, -r));
  q.z_max_ = std::clamp(std::max(a, b), -r, std::max(r, -r));
  q.theta_min_ = std::acos(std::clamp(q.z_min_ / r, -1.0, 1.0));
  q.theta_max_ = std::acos(std::clamp(q.z_max_ / r, -1.0, 1.0));
  if (!(r > 0.0) || !std::isfinite(r) || !(q.phi_max_ > 0.0) || !(q.z_max_ > q.z_min_)) return {};
  return q;
}

std::optional<Quadric> Quadric::disk(float height, float radius, float inner_radius, float phi_max,
                                     DiskCoordinates coordinates) {
  Quadric q;
  q.kind_ = Kind::Disk;
  q.coordinates_ = coordinates;
  q.radius_ = radius;
  q.inner_radius_ = std::max(0.F, inner_radius);
  q.z_min_ = q.z_max_ = height;
  q.phi_max_ = radians(std::clamp(phi_max, 0.F, 360.F));
  q.full_turn_ = phi_max >= 360.F;
  const bool finite = std::isfinite(q.radius_) && std::isfinite(q.z_min_);
  if (!finite || !(q.radius_ > q.inner_radius_) || !(q.phi_max_ > 0.0)) return {};
  return q;
}

std::optional<Quadric> Quadric::paraboloid(float radius, float z_min, float z_max, float phi_max) {
  Quadric q;
  q.kind_ = Kind::Paraboloid;
  q.radius_ = radius;
  q.z_min_ = std::max(0.F, std::min(z_min, z_max));
  q.z_max_ = std::max(z_min, z_max);
  q.phi_max_ = radians(std::clamp(phi_max, 0.F, 360.F));
  q.full_turn_ = phi_max >= 360.F;
  const bool finite = std::isfinite(q.radius_) && std::isfinite(q.z_max_);
  if (!finite || !(q.radius_ > 0.0) || !(q.z_max_ > q.z_min_) || !(q.phi_max_ > 0.0)) return {};
  return q;
}

std::optional<Quadric> Quadric::ruled(const Vec3& p1, const Vec3& p2, float phi_max) {
  Quadric q;
  q.kind_ = Kind::Ruled;
  q.p1_ = Vec3d(p1);
  q.edge_ = Vec3d(p2) - q.p1_;
  q.phi_max_ = radians(std::clamp(phi_max, 0.F, 360.F));
  q.full_turn_ = phi_max >= 360.F;
  const bool finite = is_finite(p1) && is_finite(p2);
  // A flat ring has no height to find v from; such a shape is better given as a disk.
  if (!finite || q.edge_.z == 0.0 || !(q.phi_max_ > 0.0)) return {};
  q.radius_ = std::max(radial_length(q.p1_), radial_length(q.p1_ + q.edge_));
  if (!(q.radius_ > 0.0)) return {};
  return q;
}

Vec3d Quadric::profile(double v) const {
  switch (kind_) {
    case Kind::Sphere: {
      const double theta = theta_min_ + v * (theta_max_ - theta_min_);
      return {radius_ * std::sin(theta), 0.0, radius_ * std::cos(theta)};
    }
    case Kind::Disk:
      return {radius_ + v * (inner_radius_ - radius_), 0.0, z_min_};
    case Kind::Paraboloid: {
      const double z = std::max(0.0, z_min_ + v * (z_max_ - z_min_));
      return {radius_ * std::sqrt(z / z_max_), 0.0, z};
    }
    case Kind::Ruled:
      break;
  }
  return p1_ + edge_ * v;
}

Vec3d Quadric::profile_derivative(double v) const {
  switch (kind_) {
    case Kind::Sphere: {
      const double range = theta_max_ - theta_min_;
      const double theta = theta_min_ + v * range;
      return Vec3d(std::cos(theta), 0.0, -std::sin(theta)) * (radius_ * range);
    }
    case Kind::Disk:
      return {inner_radius_ - radius_, 0.0, 0.0};
    case Kind::Paraboloid: {
      const double height = z_max_ - z_min_;
      const double z = z_min_ + v * height;
      return Vec3d(radius_ * 0.5 / std::sqrt(z * z_max_), 0.0, 1.0) * height;
    }
    case Kind::Ruled:
      break;
  }
  return edge_;
}

bool Quadric::in_range(const Vec3d& p) const {
  if (kind_ == Kind::Sphere) {
    if (z_min_ > -radius_ && p.z < z_min_) return false;
    if (z_max_ < radius_ && p.z > z_max_) return false;
  } else if (kind_ == Kind::Disk) {
    const double squared = radial_dot(p, p);
    if (squared > radius_ * radius_ || squared < inner_radius_ * inner_radius_) return false;
  } else if (kind_ == Kind::Paraboloid) {
    if (p.z < z_min_ || p.z > z_max_) return false;
  } else {
    const double v = (p.z - p1_.z) / edge_.z;
    if (v < 0.0 || v > 1.0) return false;
  }
  return full_turn_ || place_of(p).turn <= 1.0;
}

Quadric::Roots Quadric::intersect(const Vec3d& origin, const Vec3d& direction) const {
  // Solved around the ray's closest approach to the origin of object space: from far away the
  // squares below would cancel.
  const double shift = -origin.dot(direction) / direction.dot(direction);
  if (!std::isfinite(shift)) return {};
  const Vec3d o = origin + direction * shift;
  const Vec3d& d = direction;
  double t[2];
  int candidates = 0;
  switch (kind_) {
    case Kind::Sphere: {
      const double room = radius_ * radius_ - o.dot(o);
      if (room < 0.0) return {};
      const double half = std::sqrt(room / d.dot(d));
      t[0] = -half;
      t[1] = half;
      candidates = 2;
      break;
    }
    case Kind::Disk:
      if (d.z == 0.0) return {};
      t[0] = (z_min_ - o.z) / d.z;
      candidates = 1;
      break;
    case Kind::Paraboloid: {
      const double k = z_max_ / (radius_ * radius_);
      candidates = solve_quadratic(k * radial_dot(d, d), k * radial_dot(o, d) - 0.5 * d.z,
                                   k * radial_dot(o, o) - o.z, t);
      break;
    }
    case Kind::Ruled: {
      const double v0 = (o.z - p1_.z) / edge_.z;
      const double slope = d.z / edge_.z;
      const Vec3d start = p1_ + edge_ * v0;
      const double edge_squared = radial_dot(edge_, edge_);
      candidates = solve_quadratic(radial_dot(d, d) - slope * slope * edge_squared,
                                   radial_dot(o, d) - slope * radial_dot(start, edge_),
                                   radial_dot(o, o) - radial_dot(start, start), t);
      break;
    }
  }
  Roots roots;
  for (int i = 0; i < candidates; ++i) {
    if (in_range(o + d * t[i])) roots.t[roots.count++] = shift + t[i];
  }
  return roots;
}

Vec3d Quadric::project(const Vec3d& p) const {
  switch (kind_) {
    case Kind::Sphere: {
      const double size = p.length();
      return size > 0.0 ? p * (radius_ / size) : Vec3d(0.0, 0.0, radius_);
    }
    case Kind::Disk:
      return {p.x, p.y, z_min_};
    case Kind::Paraboloid:
      return {p.x, p.y, z_max_ * radial_dot(p, p) / (radius_ * radius_)};
    case Kind::Ruled:
      break;
  }
  const double radius = radial_length(p1_ + edge_ * ((p.z - p1_.z) / edge_.z));
  const double actual = radial_length(p);
  const double scale = actual > 0.0 ? radius / actual : 1.0;
  return {p.x * scale, p.y * scale, p.z};
}

Imath::V2d Quadric::parameters(const Vec3d& p) const { return parameters_at(place_of(p)); }

Imath::V2d Quadric::parameters_at(const Place& place) const {
  switch (coordinates_) {
    case DiskCoordinates::RadiusThenAngle:
      return {1.0 - place.v, place.turn};
    case DiskCoordinates::AngleThenRadius:
      return {place.turn, 1.0 - place.v};
    case DiskCoordinates::AngleThenRadiusInward:
      break;
  }
  return {place.turn, place.v};
}

Quadric::Place Quadric::place_at(const Imath::V2d& uv) const {
  switch (coordinates_) {
    case DiskCoordinates::RadiusThenAngle:
      return {uv.y, 1.0 - uv.x};
    case DiskCoordinates::AngleThenRadius:
      return {uv.x, 1.0 - uv.y};
    case DiskCoordinates::AngleThenRadiusInward:
      break;
  }
  return {uv.x, uv.y};
}

Quadric::Place Quadric::place_of(const Vec3d& p) const {
  double v = 0.0;
  double phi = std::atan2(p.y, p.x);
  switch (kind_) {
    case Kind::Sphere:
      v = (std::atan2(radial_length(p), p.z) - theta_min_) / (theta_max_ - theta_min_);
      break;
    case Kind::Disk:
      v = (radius_ - radial_length(p)) / (radius_ - inner_radius_);
      break;
    case Kind::Paraboloid:
      v = (p.z - z_min_) / (z_max_ - z_min_);
      break;
    case Kind::Ruled: {
      v = (p.z - p1_.z) / edge_.z;
      const Vec3d start = p1_ + edge_ * v;
      phi = std::atan2(start.x * p.y - start.y * p.x, radial_dot(start, p));
      break;
    }
  }
  if (phi < 0.0) phi += 2.0 * std::numbers::pi;
  return {phi / phi_max_, std::clamp(v, 0.0, 1.0)};
}

double Quadric::clamped_v(double v) const {
  v = std::clamp(v, 0.0, 1.0);
  switch (kind_) {
    case Kind::Sphere: {
      const double range = theta_max_ - theta_min_;
      const double theta = std::clamp(theta_min_ + v * range, kPole, std::numbers::pi - kPole);
      return (theta - theta_min_) / range;
    }
    case Kind::Disk: {
      const double r = std::max(radius_ + v * (inner_radius_ - radius_), kPole * radius_);
      return (radius_ - r) / (radius_ - inner_radius_);
    }
    case Kind::Paraboloid: {
      const double z = std::max(z_min_ + v * (z_max_ - z_min_), kPole * kPole * z_max_);
      return (z - z_min_) / (z_max_ - z_min_);
    }
    case Kind::Ruled:
      break;
  }
  if (radial_length(p1_ + edge_ * v) >= kPole * radius_) return v;
  const double step = kPole * radius_ / std::max(radial_length(edge_), kPole * radius_);
  return v > 0.5 ? v - step : v + step;
}

Quadric::Point Quadric::at(const Imath::V2d& uv) const {
  const Place place = place_at(uv);
  const double phi = place.turn * phi_max_;
  const double c = std::cos(phi);
  const double s = std::sin(phi);
  Point result;
  result.p = turned(profile(place.v), c, s);

  const double v = clamped_v(place.v);
  const Vec3d q = turned(profile(v), c, s);
  const Vec3d u_axis(-q.y, q.x, 0.0);  // ∂P/∂φ
  result.dpdu = u_axis * phi_max_;
  result.dpdv = turned(profile_derivative(v), c, s);
  const Vec3d d2uu = Vec3d(q.x, q.y, 0.0) * (-phi_max_ * phi_max_);
  const Vec3d d2uv = Vec3d(-result.dpdv.y, result.dpdv.x, 0.0) * phi_max_;
  Vec3d d2vv(0.0);
  if (kind_ == Kind::Sphere) {
    const double range = theta_max_ - theta_min_;
    d2vv = q * (-range * range);
  } else if (kind_ == Kind::Paraboloid) {
    const double height = z_max_ - z_min_;
    d2vv = Vec3d(q.x, q.y, 0.0) * (-0.25 * height * height / (q.z * q.z));
  }
  const Vec3d n = result.dpdu.cross(result.dpdv).normalized();
  result.n = kind_ == Kind::Sphere ? result.p.normalized() : n;
  weingarten(result.dpdu, result.dpdv, n, d2uu, d2uv, d2vv, result.dndu, result.dndv);
  // Disks are flat: their normals have no derivatives to exchange.
  if (coordinates_ != DiskCoordinates::AngleThenRadiusInward) result.dpdv = -result.dpdv;
  if (coordinates_ == DiskCoordinates::RadiusThenAngle) std::swap(result.dpdu, result.dpdv);
  return result;
}

double Quadric::ruled_area(double v) const {
  // ∫ |∂P/∂φ × ∂P/∂v| dv; the integrand is the root of a quadratic polynomial in v.
  const double p = radial_dot(p1_, p1_);
  const double m = radial_dot(p1_, edge_);
  const double e = radial_dot(edge_, edge_);
  const double h = edge_.z * edge_.z;
  return integral_of_sqrt_quadratic(e * (h + e), m * (h + e), p * h + m * m, v);
}

double Quadric::area() const {
  switch (kind_) {
    case Kind::Sphere:
      return phi_max_ * radius_ * (z_max_ - z_min_);
    case Kind::Disk:
      return phi_max_ * 0.5 * (radius_ * radius_ - inner_radius_ * inner_radius_);
    case Kind::Paraboloid: {
      const double k = z_max_ / (radius_ * radius_);
      const auto cubed = [k](double z) { return std::pow(z / k + 0.25 / (k * k), 1.5); };
      return phi_max_ * (2.0 / 3.0) * k * (cubed(z_max_) - cubed(z_min_));
    }
    case Kind::Ruled:
      break;
  }
  return phi_max_ * ruled_area(1.0);
}

Imath::V2d Quadric::uniform_parameters(const Imath::V2d& x) const {
  return parameters_at({x.x, uniform_v(x.y)});
}

Imath::V2d Quadric::uniforms_of(const Imath::V2d& uv) const {
  const Place place = place_at(uv);
  return {place.turn, area_share(place.v)};
}

double Quadric::uniform_v(double x) const {
  switch (kind_) {
    case Kind::Sphere: {
      const double z = z_min_ + x * (z_max_ - z_min_);
      const double theta = std::acos(std::clamp(z / radius_, -1.0, 1.0));
      return (theta - theta_min_) / (theta_max_ - theta_min_);
    }
    case Kind::Disk: {
      const double outer = radius_ * radius_;
      const double r = std::sqrt(outer + x * (inner_radius_ * inner_radius_ - outer));
      return (radius_ - r) / (radius_ - inner_radius_);
    }
    case Kind::Paraboloid: {
      const double k = z_max_ / (radius_ * radius_);
      const double flat = 0.25 / (k * k);
      const double low = std::pow(z_min_ / k + flat, 1.5);
      const double high = std::pow(z_max_ / k + flat, 1.5);
      const double z = k * (std::pow(low + x * (high - low), 2.0 / 3.0) - flat);
      return std::clamp((z - z_min_) / (z_max_ - z_min_), 0.0, 1.0);
    }
    case Kind::Ruled:
      break;
  }
  const double target = x * ruled_area(1.0);
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 48; ++i) {
    const double middle = 0.5 * (low + high);
    (ruled_area(middle) < target ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double Quadric::area_share(double v) const {
  switch (kind_) {
    case Kind::Sphere:
      return (profile(v).z - z_min_) / (z_max_ - z_min_);
    case Kind::Disk: {
      const double outer = radius_ * radius_;
      const double r = profile(v).x;
      return (outer - r * r) / (outer - inner_radius_ * inner_radius_);
    }
    case Kind::Paraboloid: {
      const double k = z_max_ / (radius_ * radius_);
      const auto cubed = [k](double z) { return std::pow(z / k + 0.25 / (k * k), 1.5); };
      return (cubed(profile(v).z) - cubed(z_min_)) / (cubed(z_max_) - cubed(z_min_));
    }
    case Kind::Ruled:
      break;
  }
  return ruled_area(v) / ruled_area(1.0);
}

void Quadric::bounds(Vec3d& low, Vec3d& high) const {
  const double z1 = kind_ == Kind::Ruled ? std::min(p1_.z, p1_.z + edge_.z) : z_min_;
  const double z2 = kind_ == Kind::Ruled ? std::max(p1_.z, p1_.z + edge_.z) : z_max_;
  low = Vec3d(-radius_, -radius_, z1);
  high = Vec3d(radius_, radius_, z2);
}

std::optional<double> Quadric::full_sphere_radius() const {
  const bool full = kind_ == Kind::Sphere && full_turn_ && z_min_ <= -radius_ && z_max_ >= radius_;
  return full ? std::optional(radius_) : std::nullopt;
}

SurfacePoint quadric_surface_point(const Quadric& quadric, const Placement& placement,
                                   bool reversed, const Imath::V2d& uv) {
  const Quadric::Point local = quadric.at(uv);
  const double sign = reversed ? -1.0 : 1.0;
  const Vec3d normal = placement.normal(local.n);
  const double size = normal.length();
  const Vec3d n = normal / size;
  // The derivative of the normalised normal, which the transform of a normal alone does not give.
  const auto derivative = [&](const Vec3d& dn) {
    const Vec3d moved = placement.normal(dn) * (sign / size);
    return Vec3(moved - n * n.dot(moved));
  };
  SurfacePoint point;
  point.p = Vec3(placement.point(local.p));
  point.ng = Vec3(n * sign);
  point.ns = point.ng;
  point.uv = Vec2(static_cast<float>(uv.x), static_cast<float>(uv.y));
  point.dpdu = Vec3(placement.vector(local.dpdu));
  point.dpdv = Vec3(placement.vector(local.dpdv));
  point.dndu = derivative(local.dndu);
  point.dndv = derivative(local.dndv);
  return point;
}

SurfacePoint sphere_plain_point(const Quadric& sphere, const Placement& placement, bool reversed,
                                const Vec3d& p) {
  const Imath::V2d uv = sphere.parameters(p);
  const Vec3d n = placement.normal(p).normalized();
  SurfacePoint point;
  point.p = Vec3(placement.point(p));
  point.ng = Vec3(reversed ? -n : n);
  point.ns = point.ng;
  point.uv = Vec2(static_cast<float>(uv.x), static_cast<float>(uv.y));
  point.dpdu = point.dpdv = point.dndu = point.dndv = Vec3(0.F);
  return point;
}

}  // namespace ajar
