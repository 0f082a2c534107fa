#include <algorithm>

#include "core/warp.h"
#include "scene/shape/make_surface_sampler.h"

namespace ajar {

namespace {

float unit(float u) { return std::clamp(u, 0.F, kOneMinusEpsilon); }

class QuadricSampler final : public SurfaceSampler {
 public:
  QuadricSampler(const Quadric& quadric, const Placement& placement, bool reversed)
      : quadric_(quadric),
        placement_(placement),
        reversed_(reversed),
        object_area_(quadric.area()) {
    if (const auto scale = placement.similarity_scale()) stretch_ = *scale * *scale;
    if (quadric.is_disk()) stretch_ = placement.area_stretch({0.0, 0.0, 1.0});
    area_ = stretch_ > 0.0 ? object_area_ * stretch_ : integrated_area();
  }
  float area() const override { return static_cast<float>(area_); }
  SurfaceExtent extent() const override {
    Vec3d low;
    Vec3d high;
    quadric_.bounds(low, high);
    SurfaceExtent extent;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3d p((corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
                    (corner & 4) != 0 ? high.z : low.z);
      extent.box.extendBy(Vec3(placement_.point(p)));
    }
    extent.normals = DirectionCone::whole_sphere();
    if (quadric_.is_disk()) {
      const Imath::V2d anywhere(0.5, 0.5);
      extent.normals = {quadric_surface_point(quadric_, placement_, reversed_, anywhere).ng, 0.F};
    }
    return extent;
  }
  SurfaceSample sample(const SurfaceUniforms& u) const override {
    const Imath::V2d uv = quadric_.uniform_parameters({u.position.x, u.position.y});
    SurfaceSample result;
    result.point = quadric_surface_point(quadric_, placement_, reversed_, uv);
    result.pdf = density(uv);
    return result;
  }
  Pdf<Area> pdf(const SurfacePoint& point) const override {
    return density(Imath::V2d(point.uv.x, point.uv.y));
  }
  std::optional<SurfaceUniforms> invert(const SurfacePoint& point,
                                        const SurfaceUniforms& fresh) const override {
    const Imath::V2d x = quadric_.uniforms_of({point.uv.x, point.uv.y});
    return SurfaceUniforms{fresh.primitive,
                           {unit(static_cast<float>(x.x)), unit(static_cast<float>(x.y))}};
  }

 private:
  double stretch(const Imath::V2d& uv) const {
    return stretch_ > 0.0 ? stretch_ : placement_.area_stretch(quadric_.at(uv).n);
  }
  Pdf<Area> density(const Imath::V2d& uv) const {
    return Pdf<Area>(static_cast<float>(1.0 / (object_area_ * stretch(uv))));
  }
  /// Mean stretch by the midpoint rule over uniform area.
  double integrated_area() const {
    constexpr int kSteps = 256;
    double sum = 0.0;
    for (int j = 0; j < kSteps; ++j) {
      const double v = quadric_.uniform_parameters({0.5, (j + 0.5) / kSteps}).y;
      for (int i = 0; i < kSteps; ++i) {
        sum += placement_.area_stretch(quadric_.at({(i + 0.5) / kSteps, v}).n);
      }
    }
    return object_area_ * sum / (kSteps * kSteps);
  }

  Quadric quadric_;
  Placement placement_;
  bool reversed_;
  double object_area_;
  double stretch_ = 0.0;  ///< world area per object area where it is constant, else 0
  double area_ = 0.0;
};

class SphereSampler final : public SurfaceSampler {
 public:
  SphereSampler(const Quadric& quadric, const Placement& placement, bool reversed, double radius)
      : quadric_(quadric),
        placement_(placement),
        reversed_(reversed),
        center_(placement.point(Vec3d(0.0))),
        radius_(radius),
        rounding_(
            0x1p-22 *
            (std::max({std::abs(center_.x), std::abs(center_.y), std::abs(center_.z)}) + radius)) {}

  float area() const override { return static_cast<float>(4.0 * double{kPi} * radius_ * radius_); }
  SurfaceExtent extent() const override {
    const Vec3d half(radius_);
    return {Box3(Vec3(center_ - half), Vec3(center_ + half)), DirectionCone::whole_sphere()};
  }
  SurfaceSample sample(const SurfaceUniforms& u) const override {
    const Vec3d n(warp::uniform_sphere(u.position));
    return {point_at(n), uniform_pdf()};
  }
  Pdf<Area> pdf(const SurfacePoint& /*point*/) const override { return uniform_pdf(); }

  std::optional<SurfaceSample> sample_toward(const Vec3& reference,
                                             const SurfaceUniforms& u) const override {
    const Vec3d to_reference = Vec3d(reference) - center_;
    const double distance = to_reference.length();
    if (!outside(distance)) return sample(u);
    // Angles are measured at the reference (θ) and at the centre of the sphere (α).
    const double one_minus_cos = u.position.x * one_minus_cos_max(distance);
    const double cos_theta = 1.0 - one_minus_cos;
    const double sin_squared = one_minus_cos * (1.0 + cos_theta);
    const double ratio = distance / radius_;
    const double cos_alpha =
        std::min(1.0, sin_squared * ratio +
                          cos_theta * std::sqrt(std::max(0.0, 1.0 - sin_squared * ratio * ratio)));
    const double sin_alpha = std::sqrt(std::max(0.0, 1.0 - cos_alpha * cos_alpha));
    const double phi = 2.0 * double{kPi} * u.position.y;
    Vec3d x;
    Vec3d y;
    const Vec3d z = to_reference / distance;
    axes_around(z, x, y);
    SurfaceSample result;
    result.point = point_at((x * std::cos(phi) + y * std::sin(phi)) * sin_alpha + z * cos_alpha);
    result.pdf = cone_pdf(reference, distance, result.point);
    return result;
  }

  Pdf<Area> pdf_toward(const Vec3& reference, const SurfacePoint& point) const override {
    const Vec3d to_reference = Vec3d(reference) - center_;
    const double distance = to_reference.length();
    if (!outside(distance)) return uniform_pdf();
    // Only the cap that the reference sees; the tolerance covers the rounding of points on its rim.
    const double height = (Vec3d(point.p) - center_).dot(to_reference);
    const double tolerance = 1e-5 * radius_ * distance;
    if (height < radius_ * radius_ - tolerance) return {};
    return cone_pdf(reference, distance, point);
  }

  std::optional<SurfaceUniforms> invert(const SurfacePoint& point,
                                        const SurfaceUniforms& fresh) const override {
    const Vec3d n = (Vec3d(point.p) - center_).normalized();
    return SurfaceUniforms{fresh.primitive, warp::uniform_sphere_inverse(Vec3(n))};
  }
  std::optional<SurfaceUniforms> invert_toward(const Vec3& reference, const SurfacePoint& point,
                                               const SurfaceUniforms& fresh) const override {
    const Vec3d to_reference = Vec3d(reference) - center_;
    const double distance = to_reference.length();
    if (!outside(distance)) return invert(point, fresh);
    if (!(pdf_toward(reference, point).value() > 0.F)) return std::nullopt;
    Vec3d x;
    Vec3d y;
    const Vec3d z = to_reference / distance;
    axes_around(z, x, y);
    const Vec3d n = (Vec3d(point.p) - center_).normalized();
    // The angle θ at the reference, from the triangle of reference, centre and point.
    const double along = distance - radius_ * n.dot(z);
    const double across = radius_ * n.cross(z).length();
    const double hypotenuse = std::hypot(along, across);
    const double one_minus_cos = across * across / (hypotenuse * (hypotenuse + along));
    return SurfaceUniforms{
        fresh.primitive,
        {unit(static_cast<float>(one_minus_cos / one_minus_cos_max(distance))),
         warp::turn_of({static_cast<float>(n.dot(x)), static_cast<float>(n.dot(y))})}};
  }

 private:
  /// Points of the sphere itself count as inside: rounding puts them on either side, and light that
  /// the inner side sends to the inner side must not be lost for half of them.
  bool outside(double distance) const { return distance > radius_ * (1.0 + 1e-5) + rounding_; }
  /// 1 − cos of half the angle under which the sphere is seen, without cancellation.
  double one_minus_cos_max(double distance) const {
    const double sine = radius_ / distance;
    const double cosine = std::sqrt((distance - radius_) * (distance + radius_)) / distance;
    return sine * sine / (1.0 + cosine);
  }
  Pdf<Area> uniform_pdf() const {
    return Pdf<Area>(static_cast<float>(1.0 / (4.0 * double{kPi} * radius_ * radius_)));
  }
  /// Converted with the same rounded point and normal as users convert back with, so that errors
  /// cancel at the rim.
  Pdf<Area> cone_pdf(const Vec3& reference, double distance, const SurfacePoint& point) const {
    const double density = 1.0 / (2.0 * double{kPi} * one_minus_cos_max(distance));
    return to_area(Pdf<SolidAngle>(static_cast<float>(density)), reference, point.p, point.ng);
  }
  SurfacePoint point_at(const Vec3d& n) const {
    return sphere_plain_point(quadric_, placement_, reversed_,
                              quadric_.project(placement_.vector_to_object(n)));
  }
  static void axes_around(const Vec3d& z, Vec3d& x, Vec3d& y) {
    x = std::abs(z.x) < 0.6 ? Vec3d(1.0, 0.0, 0.0) : Vec3d(0.0, 1.0, 0.0);
    x = (x - z * x.dot(z)).normalized();
    y = z.cross(x);
  }

  Quadric quadric_;
  Placement placement_;
  bool reversed_;
  Vec3d center_;
  double radius_;
  double rounding_;  ///< rounding error of the coordinates of a point of the sphere
};

}  // namespace

std::unique_ptr<SurfaceSampler> make_surface_sampler(const Quadric& quadric,
                                                     const Placement& placement, bool reversed) {
  const auto radius = quadric.full_sphere_radius();
  const auto scale = placement.similarity_scale();
  if (radius && scale) {
    return std::make_unique<SphereSampler>(quadric, placement, reversed, *radius * *scale);
  }
  return std::make_unique<QuadricSampler>(quadric, placement, reversed);
}

}  // namespace ajar
