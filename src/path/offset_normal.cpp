#include "path/offset_normal.h"

#include <cmath>

namespace ajar {

namespace {

/// η_a ω_a + η_b ω_b with η_a = 1, on the side of the shading normal.
struct Half {
  Vec3d h;
  double length;
  double eta;  ///< η_b
};
std::optional<Half> half_of(const InnerVertex& vertex, const Vec3d& a, const Vec3d& b) {
  const auto eta = relative_index(vertex, vertex.event.transmission, a);
  if (!eta) return std::nullopt;
  const Vec3d sum = a + b * *eta;
  const double length = sum.length();
  if (!(length > 0.0)) return std::nullopt;
  // No facet refracts to the side that it is seen from.
  if ((a.dot(sum) * b.dot(sum) < 0.0) != vertex.event.transmission) return std::nullopt;
  const double side = std::copysign(length, sum.dot(Vec3d(vertex.hit.point.ns)));
  return Half{sum / side, length, *eta};
}

}  // namespace

Vec3d axis_beside(const Vec3d& n) {
  return std::abs(n.x) < 0.7 ? Vec3d(1.0, 0.0, 0.0) : Vec3d(0.0, 1.0, 0.0);
}

TangentPlane plane_across(const Vec3d& n) {
  const Vec3d axis = axis_beside(n);
  const Vec3d x = (axis - n * n.dot(axis)).normalized();
  return {x, n.cross(x)};
}

Vec3d normal_before_bumps(const InnerVertex& vertex) {
  return Vec3d(vertex.hit.point.ns).normalized();
}

std::optional<Vec3d> facet_normal(const InnerVertex& vertex, const OffsetNormal& offset) {
  const double squared = offset.x * offset.x + offset.y * offset.y;
  if (!(squared < 1.0)) return std::nullopt;
  const Vec3d n = normal_before_bumps(vertex);
  const TangentPlane plane = plane_across(n);
  return plane.x * offset.x + plane.y * offset.y + n * std::sqrt(1.0 - squared);
}

std::optional<double> relative_index(const InnerVertex& vertex, bool transmission, const Vec3d& w) {
  if (!transmission) return 1.0;
  const double eta = double{vertex.bsdf.rough_eta()};
  if (eta == 1.0) return std::nullopt;
  return w.dot(Vec3d(vertex.hit.point.ng)) > 0.0 ? eta : 1.0 / eta;
}

std::optional<OffsetNormal> offset_normal(const InnerVertex& vertex, const Vec3d& a,
                                          const Vec3d& b) {
  const auto half = half_of(vertex, a, b);
  if (!half) return std::nullopt;
  const TangentPlane plane = plane_across(normal_before_bumps(vertex));
  return OffsetNormal{plane.x.dot(half->h), plane.y.dot(half->h)};
}

std::optional<Vec3d> turn(const InnerVertex& vertex, bool transmission, const OffsetNormal& offset,
                          const Vec3d& w) {
  const auto m = facet_normal(vertex, offset);
  const auto eta = relative_index(vertex, transmission, w);
  if (!m || !eta) return std::nullopt;
  const double cosine = w.dot(*m);
  Vec3d turned = *m * (2.0 * cosine) - w;
  if (transmission) {
    // Snell's law, with m on the side of w.
    const double squared = 1.0 - (1.0 - cosine * cosine) / (*eta * *eta);
    if (!(squared > 0.0)) return std::nullopt;
    turned = (*m * cosine - w) / *eta - *m * std::copysign(std::sqrt(squared), cosine);
  }
  const Vec3d ng(vertex.hit.point.ng);
  const bool crosses = w.dot(ng) * turned.dot(ng) < 0.0;
  if (crosses != transmission) return std::nullopt;
  return turned.normalized();
}

double offset_change(const InnerVertex& vertex, const Vec3d& a, const Vec3d& b) {
  const auto half = half_of(vertex, a, b);
  if (!half) return 0.0;
  // The half vector's length is ω_a·h + η_b ω_b·h.
  return half->eta * half->eta * std::abs(b.dot(half->h)) / (half->length * half->length) *
         half->h.dot(normal_before_bumps(vertex));
}

}  // namespace ajar
