#include "scene/shape/curve_shape.h"

#include <algorithm>

#include "core/frame.h"
#include "scene/coordinate_limit.h"

namespace ajar {

CurveShape::CurveShape(Type type, const desc::Curves& curves, const Placement& placement,
                       bool reversed, const SourceLocation& where)
    : type_(type), reversed_(reversed) {
  const std::size_t count = curves.control_points.size();
  if (count % 4 != 0 || curves.widths.size() != count) {
    throw SceneError(where, "a curve needs four control points per segment and a width for each");
  }
  if (type_ == Type::Ribbon && curves.normals.size() != count) {
    throw SceneError(where, "a ribbon needs a normal for each control point");
  }
  const double scale = placement.mean_scale();
  vertices_.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 p(placement.point(Vec3d(curves.control_points[i])));
    const auto radius = static_cast<float>(0.5 * scale * std::abs(curves.widths[i]));
    check_reach(where, "control point " + std::to_string(i) + " of the curve",
                reach_of(Vec3d(p) - Vec3d(radius), Vec3d(p) + Vec3d(radius)));
    vertices_.push_back({p.x, p.y, p.z, radius});
    if (i % 4 == 0) first_vertex_.push_back(static_cast<unsigned>(i));
  }
  if (type_ != Type::Ribbon) return;
  normals_.reserve(count + 1);
  for (const Vec3& n : curves.normals)
    normals_.emplace_back(placement.normal(Vec3d(n)).normalized());
}

CurveShape::Sample CurveShape::sample(std::uint32_t segment, double u) const {
  const std::array<float, 4>* c = vertices_.data() + first_vertex_[segment];
  const double w = 1.0 - u;
  const double weights[4] = {w * w * w, 3.0 * w * w * u, 3.0 * w * u * u, u * u * u};
  const double slopes[4] = {-3.0 * w * w, 3.0 * w * (w - 2.0 * u), 3.0 * u * (2.0 * w - u),
                            3.0 * u * u};
  Sample result{Vec3d(0.0), Vec3d(0.0), 0.0};
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3d p(c[i][0], c[i][1], c[i][2]);
    result.center += p * weights[i];
    result.tangent += p * slopes[i];
    result.radius += c[i][3] * weights[i];
  }
  if (!(result.tangent.length() > 0.0)) {
    // Control points that coincide at an end.
    result.tangent = Vec3d(c[3][0], c[3][1], c[3][2]) - Vec3d(c[0][0], c[0][1], c[0][2]);
  }
  return result;
}

SurfacePoint CurveShape::surface_point(std::uint32_t segment, float u, const Vec3& origin,
                                       const Vec3& direction, float t, const Vec3& ng) const {
  const Sample at = sample(segment, u);
  const Vec3d d(direction);
  Vec3d p = Vec3d(origin) + d * double{t};
  const double speed = at.tangent.length();
  const Vec3d along =
      speed > 0.0 ? at.tangent / speed : Vec3d(Frame::around(direction.normalized()).x);
  Vec3d side = d.cross(along);
  const double side_length = side.length();
  side = side_length > 0.0 ? side / side_length : Vec3d(Frame::around(Vec3(along)).x);

  Vec3d n(ng);
  const double n_length = n.length();
  n = n_length > 0.0 && std::isfinite(n_length) ? n / n_length : side.cross(along);
  if (type_ == Type::Flat) {
    n = along.cross(side);
    if (n.dot(d) > 0.0) n = -n;
  } else if (type_ == Type::Cylinder) {
    // Back onto the tube: the ray's own rounding grows with its length.
    const Vec3d away = p - at.center;
    const double distance = away.length();
    if (distance > 0.0) p = at.center + away * (at.radius / distance);
    if (n.dot(away) < 0.0) n = -n;
  } else {
    side = n.cross(along);
  }
  const double width = 2.0 * at.radius;
  const double across = width > 0.0 ? (p - at.center).dot(side) / width : 0.0;

  SurfacePoint point;
  point.p = Vec3(p);
  point.ng = Vec3(reversed_ ? -n : n);
  point.ns = point.ng;
  point.uv = Vec2(u, static_cast<float>(std::clamp(across + 0.5, 0.0, 1.0)));
  point.dpdu = speed > 0.0 ? Vec3(at.tangent) : Vec3(along);
  point.dpdv = Vec3(side * std::max(width, 1e-30));
  point.dndu = point.dndv = Vec3(0.F);
  point.primitive = segment;
  return point;
}

std::optional<SurfaceDerivatives> CurveShape::derivatives(std::uint32_t segment, double u,
                                                          const Vec3d& p) const {
  if (type_ != Type::Cylinder) return std::nullopt;
  const Sample here = sample(segment, u);
  if (!(here.tangent.length() > 0.0) || !(here.radius > 0.0)) return std::nullopt;
  const Vec3d axis = here.tangent.normalized();
  const Vec3d away = p - here.center;
  const Vec3d x = (away - axis * axis.dot(away)).normalized();
  const Vec3d y = axis.cross(x);
  // The circle around the curve, perpendicular to it.
  const auto at = [&](double along, double angle) {
    const Sample moved = sample(segment, along);
    const Vec3d t = moved.tangent.normalized();
    const Vec3d out = x * std::cos(angle) + y * std::sin(angle);
    return moved.center + (out - t * t.dot(out)).normalized() * moved.radius;
  };
  // Central differences of differences: in double precision good to about 10⁻⁷ of the whole.
  constexpr double kStep = 1e-3;
  const auto along_u = [&](double a, double b) {
    return (at(a + kStep, b) - at(a - kStep, b)) / (2.0 * kStep);
  };
  const auto along_v = [&](double a, double b) {
    return (at(a, b + kStep) - at(a, b - kStep)) / (2.0 * kStep);
  };
  const auto normal = [&](double a, double b) {
    return along_v(a, b).cross(along_u(a, b)).normalized();
  };
  return SurfaceDerivatives{normal(u, 0.0), along_u(u, 0.0), along_v(u, 0.0),
                            (normal(u + kStep, 0.0) - normal(u - kStep, 0.0)) / (2.0 * kStep),
                            (normal(u, kStep) - normal(u, -kStep)) / (2.0 * kStep)};
}

float CurveShape::self_distance(std::uint32_t segment, float u) const {
  const float factor = type_ == Type::Flat ? 2.F : 0.02F;
  return factor * static_cast<float>(sample(segment, u).radius);
}

}  // namespace ajar
