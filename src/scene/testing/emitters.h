#pragma once
#include <cmath>
#include <optional>

#include "core/warp.h"
#include "scene/desc/models.h"
#include "scene/emission/emission.h"
#include "scene/shape/surface_sampler.h"
#include "scene/texture/texture.h"

/// Simple surfaces for tests of lights and cameras, independent of the real shapes.
namespace ajar::testing {

inline SurfacePoint flat_point(const Vec3& p, const Vec3& n, const Vec2& uv, const Vec3& dpdu,
                               const Vec3& dpdv) {
  const Vec3 zero(0.F);
  return {p, n, n, uv, dpdu, dpdv, zero, zero, 0};
}

/// Parallelogram; ng = normalize(edge_u × edge_v).
class Quad final : public SurfaceSampler {
 public:
  Quad(const Vec3& corner, const Vec3& edge_u, const Vec3& edge_v)
      : corner_(corner), u_(edge_u), v_(edge_v), normal_(cross(edge_u, edge_v)) {
    area_ = length(normal_);
    normal_ /= area_;
  }
  float area() const override { return area_; }
  SurfaceExtent extent() const override {
    Box3 box(corner_);
    for (const Vec3& edge : {u_, v_, u_ + v_}) box.extendBy(corner_ + edge);
    return {box, {normal_, 0.F}};
  }
  SurfaceSample sample(const SurfaceUniforms& u) const override {
    return {at(u.position), Pdf<Area>(1.F / area_)};
  }
  Pdf<Area> pdf(const SurfacePoint& /*point*/) const override { return Pdf<Area>(1.F / area_); }

  std::optional<SurfaceUniforms> invert(const SurfacePoint& point,
                                        const SurfaceUniforms& fresh) const override {
    return SurfaceUniforms{fresh.primitive, point.uv};
  }

  SurfacePoint at(const Vec2& uv) const {
    return flat_point(corner_ + u_ * uv.x + v_ * uv.y, normal_, uv, u_, v_);
  }
  const Vec3& normal() const { return normal_; }
  std::optional<SurfacePoint> intersect(const Vec3& origin, const Vec3& w) const {
    const float t = dot(corner_ - origin, normal_) / dot(w, normal_);
    if (!(t > 0.F) || !std::isfinite(t)) return std::nullopt;
    const Vec3 d = origin + w * t - corner_;
    const Vec2 uv(dot(cross(d, v_), normal_) / area_, dot(cross(u_, d), normal_) / area_);
    if (uv.x < 0.F || uv.x >= 1.F || uv.y < 0.F || uv.y >= 1.F) return std::nullopt;
    return at(uv);
  }

 private:
  Vec3 corner_, u_, v_, normal_;
  float area_;
};

/// Sphere with outward normals, sampled uniformly by area.
class Ball final : public SurfaceSampler {
 public:
  Ball(const Vec3& center, float radius) : center_(center), radius_(radius) {}
  float area() const override { return 4.F * kPi * radius_ * radius_; }
  SurfaceExtent extent() const override {
    return {Box3(center_ - Vec3(radius_), center_ + Vec3(radius_)), DirectionCone::whole_sphere()};
  }
  SurfaceSample sample(const SurfaceUniforms& u) const override {
    return {at(warp::uniform_sphere(u.position)), Pdf<Area>(1.F / area())};
  }
  Pdf<Area> pdf(const SurfacePoint& /*point*/) const override { return Pdf<Area>(1.F / area()); }

  std::optional<SurfaceUniforms> invert(const SurfacePoint& point,
                                        const SurfaceUniforms& fresh) const override {
    return SurfaceUniforms{fresh.primitive, warp::uniform_sphere_inverse(point.ng)};
  }

  SurfacePoint at(const Vec3& n) const {
    const Vec3 tangent = cross(std::abs(n.z) < 0.9F ? Vec3(0, 0, 1) : Vec3(1, 0, 0), n);
    return flat_point(center_ + n * radius_, n, {0.5F + 0.5F * n.x, 0.5F + 0.5F * n.y}, tangent,
                      cross(n, tangent));
  }
  std::optional<SurfacePoint> intersect(const Vec3& origin, const Vec3& w) const {
    const Vec3 d = center_ - origin;
    const float along = dot(d, w);
    const float miss = length_squared(d - w * along);
    if (along <= 0.F || miss >= radius_ * radius_) return std::nullopt;
    const float t = along - std::sqrt(radius_ * radius_ - miss);
    return at(normalize(origin + w * t - center_));
  }

 private:
  Vec3 center_;
  float radius_;
};

/// `radiance` multiplies the texture, if there is one.
inline desc::Emission area_light(const desc::Rgb& radiance, bool two_sided = false,
                                 desc::TextureId texture = desc::kNone) {
  if (texture == desc::kNone) {
    return {{}, desc::emission_node("area", {{"radiance", radiance}, {"two_sided", two_sided}})};
  }
  return {{},
          desc::emission_node("area", {{"radiance", desc::TextureRef{texture}},
                                       {"scale", radiance},
                                       {"two_sided", two_sided}})};
}

/// (u, v, 1 − u) + 0.2: different in every direction.
class RampTexture final : public Texture {
 public:
  Spectrum eval(const SurfacePoint& at) const override {
    return Spectrum(at.uv.x, at.uv.y, 1.F - at.uv.x) + Spectrum(0.2F);
  }
};

inline TextureList one_ramp() {
  TextureList list;
  list.push_back(std::make_unique<RampTexture>());
  return list;
}

}  // namespace ajar::testing
