#include "path/specular_chain.h"

#include <algorithm>
#include <cmath>

#include "scene/surface_derivatives.h"

namespace ajar {

namespace {

using Block = std::array<double, 4>;

Block product(const Block& a, const Block& b) {
  return {a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2],
          a[2] * b[1] + a[3] * b[3]};
}
Block difference(const Block& a, const Block& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]};
}
Block negative(const Block& a) { return {-a[0], -a[1], -a[2], -a[3]}; }
double determinant(const Block& a) { return a[0] * a[3] - a[1] * a[2]; }
std::optional<Block> inverse(const Block& a) {
  const double d = determinant(a);
  const double size = a[0] * a[0] + a[1] * a[1] + a[2] * a[2] + a[3] * a[3];
  // The remaining determinant is rounding error.
  if (!(std::abs(d) > 1e-12 * size) || !std::isfinite(size)) return std::nullopt;
  return Block{a[3] / d, -a[1] / d, -a[2] / d, a[0] / d};
}
/// rowsᵀ · (vectors of `columns`).
Block project(const TangentPlane& rows, const Vec3d& first, const Vec3d& second) {
  return {rows.x.dot(first), rows.x.dot(second), rows.y.dot(first), rows.y.dot(second)};
}

/// A neighbour of a vertex.
struct Ray3 {
  Vec3d w;                ///< toward it
  double per_move = 0.0;  ///< change of direction per move across it: 1/distance; 0 at infinity
  double eta = 1.0;
};

Ray3 ray_to(const Vec3d& p, const ChainEnd& end) {
  if (end.at_infinity) return {end.toward, 0.0, 1.0};
  const Vec3d d = end.p - p;
  const double distance = d.length();
  return {d / distance, 1.0 / distance, 1.0};
}

/// The part of `v` across `w`.
Vec3d part_across(const Vec3d& v, const Vec3d& w) { return v - w * w.dot(v); }

ChainEnd at(const InnerVertex& vertex) { return {Vec3d(vertex.p()), Vec3d(0.0), false}; }

/// Scattering of a vertex.
struct Optics {
  double eta;  ///< on the side of the end over that on the side of the start
  bool straight;
};
std::optional<Optics> optics_of(const InnerVertex& vertex, const Vec3d& to_start) {
  if (!vertex.event.specular()) {
    const auto eta = relative_index(vertex, vertex.event.transmission, to_start);
    return eta ? std::optional(Optics{*eta, false}) : std::nullopt;
  }
  const auto sample = vertex.bsdf.specular(Vec3(to_start), vertex.event, TransportMode::Radiance);
  if (!sample) return std::nullopt;
  return Optics{double{sample->eta}, sample->transmission && sample->eta == 1.F};
}

/// Derivative of the unit shading normal along a tangent of the surface.
Vec3d normal_change(const SurfaceDerivatives& surface, const Vec3d& along) {
  const Vec3d area = surface.dpdu.cross(surface.dpdv);
  const double squared = area.dot(area);
  return surface.dndu * (along.cross(surface.dpdv).dot(area) / squared) +
         surface.dndv * (surface.dpdu.cross(along).dot(area) / squared);
}

/// The normal that a vertex holds, and how it turns with the shading normal.
class HeldNormal {
 public:
  HeldNormal(const Vec3d& n, const OffsetNormal& offset)
      : n_(n),
        plane_(plane_across(n)),
        offset_(offset),
        height_(std::sqrt(1.0 - offset.x * offset.x - offset.y * offset.y)) {}
  Vec3d unit() const { return combined(plane_.x, plane_.y, n_); }
  /// When the shading normal moves by `dn`.
  Vec3d change(const Vec3d& dn) const {
    // The tangents are functions of n: the first is what is left of a fixed axis.
    const Vec3d axis = axis_beside(n_);
    const double length = (axis - n_ * n_.dot(axis)).length();
    const Vec3d dx = part_across((dn * -n_.dot(axis) - n_ * dn.dot(axis)) / length, plane_.x);
    return combined(dx, dn.cross(plane_.x) + n_.cross(dx), dn);
  }

 private:
  Vec3d combined(const Vec3d& x, const Vec3d& y, const Vec3d& n) const {
    return x * offset_.x + y * offset_.y + n * height_;
  }
  Vec3d n_;
  TangentPlane plane_;
  OffsetNormal offset_;
  double height_;
};

}  // namespace

bool can_hold(const InnerVertex& vertex) {
  if (vertex.in_medium || vertex.hit.material->index_varies) return false;
  return !vertex.event.specular() || vertex.hit.material->relief.is_flat();
}

ChainEnd chain_end(const Path& path, int x) {
  if (x == 0 && path.light->at_infinity()) {
    return {Vec3d(0.0), Vec3d(path.light_point.toward), true};
  }
  return {Vec3d(path.position(x)), Vec3d(0.0), false};
}

bool SpecularChain::set(const ChainEnd& start, std::span<const InnerVertex> vertices,
                        const ChainEnd& end, std::span<const OffsetNormal> offsets) {
  const std::size_t count = vertices.size();
  links_.resize(count);
  mirrored_ = false;
  std::vector<SurfaceDerivatives> surfaces;
  for (std::size_t i = 0; i < count; ++i) {
    const bool lacks_offset = !vertices[i].event.specular() && offsets.empty();
    if (lacks_offset || !can_hold(vertices[i])) return false;
    const auto surface = scene_.derivatives(vertices[i].hit);
    if (!surface) return false;
    surfaces.push_back(*surface);
    const TangentPlane tangents = plane_across(surface->dpdu.cross(surface->dpdv).normalized());
    links_[i].x = tangents.x;
    links_[i].y = tangents.y;
  }
  for (std::size_t i = 0; i < count; ++i) {
    Link& link = links_[i];
    const Vec3d p(vertices[i].p());
    Ray3 a = ray_to(p, i == 0 ? start : at(vertices[i - 1]));
    Ray3 b = ray_to(p, i + 1 == count ? end : at(vertices[i + 1]));
    const auto optics = optics_of(vertices[i], a.w);
    if (!optics) return false;
    b.eta = optics->eta;
    const SurfaceDerivatives& surface = surfaces[i];
    // Offset normals are around the normal of the hit, which is rounded.
    const HeldNormal held = vertices[i].event.specular()
                                ? HeldNormal(surface.n, OffsetNormal())
                                : HeldNormal(normal_before_bumps(vertices[i]), offsets[i]);
    const Vec3d normal = held.unit();
    const Vec3d& pole = optics->straight ? a.w : normal;
    const TangentPlane plane = plane_across(pole);
    // Both pairs of tangents are right-handed, each around a normal of its own.
    if (link.x.cross(link.y).dot(pole) < 0.0) mirrored_ = !mirrored_;
    const auto change = [&](const Ray3& ray, const Vec3d& move) {
      return part_across(move, ray.w) * (ray.eta * ray.per_move);
    };
    const double along_normal = optics->straight ? 0.0 : (a.w * a.eta + b.w * b.eta).dot(normal);
    const auto own = [&](const Vec3d& move) {
      const Vec3d turning = held.change(normal_change(surface, move));
      return -change(a, move) - change(b, move) - turning * along_normal;
    };
    link.own = project(plane, own(link.x), own(link.y));
    if (i > 0) {
      link.before = project(plane, change(a, links_[i - 1].x), change(a, links_[i - 1].y));
    } else {
      away_ = -a.w;
      distance_ = start.at_infinity ? 1.0 : 1.0 / a.per_move;
    }
    if (i + 1 < count) {
      link.after = project(plane, change(b, links_[i + 1].x), change(b, links_[i + 1].y));
      continue;
    }
    const TangentPlane last = plane_across(b.w);
    end_x_ = last.x;
    end_y_ = last.y;
    // An end at infinity moves by its direction.
    if (end.at_infinity) b.per_move = 1.0;
    link.after = project(plane, change(b, end_x_), change(b, end_y_));
  }

  // Forward elimination; on the right hand side only the last block is not 0.
  Block pivot_inverse{};
  for (std::size_t i = 0; i < count; ++i) {
    Block pivot = links_[i].own;
    if (i > 0) {
      pivot =
          difference(pivot, product(product(links_[i].before, pivot_inverse), links_[i - 1].after));
    }
    const auto inverted = inverse(pivot);
    if (!inverted) return false;
    if (determinant(pivot) < 0.0) mirrored_ = !mirrored_;
    pivot_inverse = *inverted;
    links_[i].by_end = negative(product(pivot_inverse, links_[i].after));
  }
  for (std::size_t i = count - 1; i-- > 0;) {
    links_[i].by_end = product(links_[i].by_end, links_[i + 1].by_end);
  }
  return true;
}

Vec3d SpecularChain::moved(std::size_t i, const Vec3d& by) const {
  const Link& link = links_[i];
  const double u = end_x_.dot(by);
  const double v = end_y_.dot(by);
  return link.x * (link.by_end[0] * u + link.by_end[1] * v) +
         link.y * (link.by_end[2] * u + link.by_end[3] * v);
}

double SpecularChain::largest_move() const {
  double largest = 0.0;
  for (const Link& link : links_) {
    double sum = 0.0;
    for (const double d : link.by_end) sum += d * d;
    largest = std::max(largest, std::sqrt(sum));
  }
  return largest;
}

double SpecularChain::spread() const {
  const Link& link = links_.front();
  const TangentPlane plane = plane_across(away_);
  return std::abs(determinant(product(project(plane, link.x, link.y), link.by_end))) /
         (distance_ * distance_);
}

}  // namespace ajar
