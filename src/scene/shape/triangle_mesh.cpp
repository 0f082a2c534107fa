#include "scene/shape/triangle_mesh.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <limits>

#include "core/frame.h"
#include "core/parallel_for.h"
#include "scene/coordinate_limit.h"

namespace ajar {

namespace {

constexpr WarningKind kWrongNumber{
    Effect::Surface, "meshes have normals, tangents or texture coordinates that are ignored"};

constexpr std::size_t kGrain = 16384;
constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();

template <typename Body>
void for_each_index(std::size_t count, const Body& body) {
  parallel_for_ranges(count, kGrain, [&](const tbb::blocked_range<std::size_t>& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
  });
}

/// Smallest index for which `is_bad`, or kNowhere.
template <typename Predicate>
std::size_t first_bad(std::size_t count, const Predicate& is_bad) {
  ForkJoin loop;
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, count, kGrain), kNowhere,
      [&](const tbb::blocked_range<std::size_t>& range, std::size_t found) {
        const ForkJoin::Task task(loop);
        for (std::size_t i = range.begin(); i < range.end() && found == kNowhere; ++i) {
          if (is_bad(i)) found = i;
        }
        return found;
      },
      [](std::size_t a, std::size_t b) { return std::min(a, b); });
}

/// Transform in double precision with the rows at hand, as millions of vertices pass through here.
struct Affine {
  explicit Affine(const Mat4& m) {
    for (int i = 0; i < 4; ++i) rows[i] = Vec3d(m[i][0], m[i][1], m[i][2]);
  }
  Vec3 point(const Vec3& p) const {
    return Vec3(rows[0] * double{p.x} + rows[1] * double{p.y} + rows[2] * double{p.z} + rows[3]);
  }
  Vec3 vector(const Vec3& p) const {
    return Vec3(rows[0] * double{p.x} + rows[1] * double{p.y} + rows[2] * double{p.z});
  }
  Vec3d rows[4];
};

Vec3 interpolate(const Vec3& a, const Vec3& b, const Vec3& c, float b0, float b1, float b2) {
  return a * b0 + b * b1 + c * b2;
}

/// The point in double precision. Rounded once, its distance to the plane of the triangle is known
/// to be half an ulp of the point itself, however large the triangle is.
Vec3d exact_point(const Vec3& p0, const Vec3& p1, const Vec3& p2, float b1, float b2) {
  const double u = b1;
  const double v = b2;
  const double w = 1.0 - u - v;
  return {w * p0.x + u * p1.x + v * p2.x, w * p0.y + u * p1.y + v * p2.y,
          w * p0.z + u * p1.z + v * p2.z};
}

/// Unit normal by the winding. In double precision, since squares of areas leave the range of
/// floats; any direction serves triangles without area.
Vec3 unit_normal(const Vec3& p0, const Vec3& p1, const Vec3& p2) {
  const Vec3d e1 = Vec3d(p1) - Vec3d(p0);
  const Vec3d e2 = Vec3d(p2) - Vec3d(p0);
  const Vec3d n = e1.cross(e2);
  const double squared = n.dot(n);
  if (squared > 0.0) return Vec3(n * (1.0 / std::sqrt(squared)));
  const double along = std::max(e1.length(), e2.length());
  if (!(along > 0.0) || !std::isfinite(along)) return {0.F, 0.F, 1.F};
  return Frame::around(Vec3((e1.length() >= e2.length() ? e1 : e2) / along)).x;
}

/// Error of Embree's plane test of a triangle; 0 if it is no more than the roundings that
/// `offset_ray_origin` leaves for it.
float plane_error_of(const Vec3& p0, const Vec3& p1, const Vec3& p2) {
  const Vec3d e1 = Vec3d(p1) - Vec3d(p0);
  const Vec3d e2 = Vec3d(p2) - Vec3d(p0);
  const Vec3d n = e1.cross(e2);
  const double size = n.length();
  if (!(size > 0.0)) return 0.F;
  double error = 0.0;  // both in half ulps
  double left = 0.0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const double low = std::min({p0[i], p1[i], p2[i]});
    const double high = std::max({p0[i], p1[i], p2[i]});
    const double nearest = std::max({0.0, low, -high});
    const double cancelled = std::abs(e1[j] * e2[k]) + std::abs(e1[k] * e2[j]);
    error += 2.0 * (high - low) * (3.0 * std::abs(n[i]) + 2.0 * cancelled) / size;
    // Two of its roundings are spent on the point.
    left += (double{kOffsetRoundings} - 2.0) * std::abs(n[i]) / size * nearest;
  }
  return error > left ? static_cast<float>(error * double{kHalfUlp}) : 0.F;
}

/// Meshes within this need no closer look: products of any three lengths in them, which Embree's
/// triangle test makes, are finite.
constexpr float kSurelySmall = 1e12F;

float largest_coordinate(const Vec3& p) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

/// True if Embree's test of the triangle, twice the parallelepiped of two edges and the way from
/// the origin of the ray to a corner, overflows for rays from about as far as the triangle itself.
/// Hits then have no distance and shadow rays miss.
bool triangle_test_overflows(const Vec3& p0, const Vec3& p1, const Vec3& p2) {
  const float away =
      std::max({largest_coordinate(p0), largest_coordinate(p1), largest_coordinate(p2)});
  return !std::isfinite(2.F * length(cross(p1 - p0, p2 - p0)) * away);
}

}  // namespace

TriangleMesh::TriangleMesh(std::shared_ptr<const desc::Mesh> source, const Placement& placement,
                           bool reversed, const SourceLocation& where, Warnings& warnings)
    : source_(std::move(source)),
      triangle_count_(source_->indices.size()),
      flip_winding_(reversed != placement.mirrors()),
      reversed_(reversed),
      mirrors_(placement.mirrors()) {
  const std::size_t vertices = source_->positions.size();
  const auto usable = [&](const auto& attribute, const char* name) {
    if (attribute.empty() || attribute.size() == vertices) return !attribute.empty();
    warnings.add(kWrongNumber, where,
                 std::string("the mesh has ") + std::to_string(attribute.size()) + " " + name +
                     " for " + std::to_string(vertices) + " vertices; they are ignored");
    return false;
  };
  has_normals_ = usable(source_->normals, "normals");
  has_uvs_ = usable(source_->uvs, "texture coordinates");
  const bool has_tangents = usable(source_->tangents, "tangents");
  vertex_count_ = vertices;
  place(placement, source_.use_count() == 1);
  if (!has_tangents) tangents_ = nullptr;
  if (has_tangents && usable(source_->handedness, "signs of tangents")) {
    handedness_ = source_->handedness.data();
  }
  triangles_ = source_->indices.data();
  validate(where);
}

void TriangleMesh::place(const Placement& placement, bool unique) {
  const desc::Mesh& mesh = *source_;
  const Affine to_world(placement.to_world());
  tangents_ = mesh.tangents.data();
  if (!placement.is_identity()) {
    own_tangents_ = mesh.tangents;
    for_each_index(own_tangents_.size(),
                   [&](std::size_t i) { own_tangents_[i] = to_world.vector(own_tangents_[i]); });
    tangents_ = own_tangents_.data();
  }

  if (has_normals_ || has_uvs_) {
    place_with_attributes(placement);
    if (unique) {
      // The mesh is uniquely owned, and was not created const (see the header).
      auto& mine = const_cast<desc::Mesh&>(mesh);
      mine.positions = {};
      mine.normals = {};
      mine.uvs = {};
    }
    return;
  }

  positions_ = mesh.positions.data();
  const bool has_spare = mesh.positions.capacity() > mesh.positions.size();
  if (placement.is_identity() && has_spare) return;
  if (unique) {
    own_positions_ = std::move(const_cast<desc::Mesh&>(mesh).positions);
    own_positions_.reserve(vertex_count_ + 1);
  } else {
    own_positions_.reserve(vertex_count_ + 1);
    own_positions_.assign(mesh.positions.begin(), mesh.positions.end());
  }
  if (!placement.is_identity()) {
    for_each_index(own_positions_.size(),
                   [&](std::size_t i) { own_positions_[i] = to_world.point(own_positions_[i]); });
  }
  positions_ = own_positions_.data();
}

void TriangleMesh::place_with_attributes(const Placement& placement) {
  const desc::Mesh& mesh = *source_;
  const bool moves = !placement.is_identity();
  const Affine to_world(placement.to_world());
  const Affine for_normals(placement.to_object().transposed());
  vertices_.resize(vertex_count_);
  for_each_index(vertex_count_, [&](std::size_t i) {
    const Vec3& p = mesh.positions[i];
    Vec3 n = has_normals_ ? mesh.normals[i] : Vec3(0.F);
    if (moves && has_normals_) {
      // Scaled here, so that vertices of one triangle keep equal weight in the interpolation.
      const Vec3 moved = for_normals.vector(n);
      const float size = length(moved);
      n = size > 0.F && std::isfinite(size) ? moved * (length(n) / size) : moved;
    }
    vertices_[i] = {moves ? to_world.point(p) : p, n, has_uvs_ ? mesh.uvs[i] : Vec2(0.F)};
  });
  positions_ = &vertices_.data()->p;
  stride_ = sizeof(Vertex);
}

void TriangleMesh::validate(const SourceLocation& where) {
  const auto first_beyond = [this](float limit) {
    return first_bad(vertex_count_, [this, limit](std::size_t i) {
      const Vec3& p = position(i);
      return !(std::abs(p.x) <= limit && std::abs(p.y) <= limit && std::abs(p.z) <= limit);
    });
  };
  const bool is_small = first_beyond(kSurelySmall) == kNowhere;
  if (!is_small) {
    const std::size_t bad_vertex = first_beyond(kMaxCoordinate);
    if (bad_vertex != kNowhere) {
      check_reach(where, "vertex " + std::to_string(bad_vertex) + " of the mesh",
                  reach_of(Box3(position(bad_vertex))));
    }
  }
  const auto out_of_range = [this](std::size_t i) {
    const Triangle& t = triangles_[i];
    return std::max({t.x, t.y, t.z}) >= vertex_count_;
  };
  const std::size_t bad_triangle = first_bad(triangle_count_, out_of_range);
  if (bad_triangle != kNowhere) {
    const Triangle& t = triangles_[bad_triangle];
    throw SceneError(where, "triangle " + std::to_string(bad_triangle) + " uses vertex " +
                                std::to_string(std::max({t.x, t.y, t.z})) + " of a mesh with " +
                                std::to_string(vertex_count_) + " vertices");
  }
  if (!is_small) {
    const std::size_t large = first_bad(triangle_count_, [this](std::size_t i) {
      const Triangle& t = triangles_[i];
      return triangle_test_overflows(position(t.x), position(t.y), position(t.z));
    });
    if (large != kNowhere) {
      throw SceneError(where, "triangle " + std::to_string(large) +
                                  " of the mesh is too large to be traced in single precision: "
                                  "scale the scene down, or use a disk, which may be larger");
    }
  }
  ForkJoin loop;
  plane_error_ = tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, triangle_count_, kGrain), 0.F,
      [&](const tbb::blocked_range<std::size_t>& range, float largest) {
        const ForkJoin::Task task(loop);
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
          const Triangle& t = triangles_[i];
          largest = std::max(largest, plane_error_of(position(t.x), position(t.y), position(t.z)));
        }
        return largest;
      },
      [](float a, float b) { return std::max(a, b); });
}

void TriangleMesh::texture_point(std::uint32_t triangle, float b1, float b2,
                                 SurfacePoint& point) const {
  const Triangle& t = triangles_[triangle];
  point.p = Vec3(exact_point(position(t.x), position(t.y), position(t.z), b1, b2));
  const float b0 = 1.F - b1 - b2;
  point.uv = has_uvs_ ? vertices_[t.x].uv * b0 + vertices_[t.y].uv * b1 + vertices_[t.z].uv * b2
                      : Vec2(b1 + b2, b2);
  point.primitive = triangle;
}

template <bool kDerivatives>
Vec3d TriangleMesh::find_point(std::uint32_t triangle, float b1, float b2,
                               SurfacePoint& point) const {
  const Triangle t = triangles_[triangle];
  // Large meshes are not in the cache. All that is needed is asked for at once, because the
  // processor does not look far enough ahead to overlap these misses by itself.
  for (int k = 0; k < 3; ++k) __builtin_prefetch(&position(t[k]));
  const Vec3& p0 = position(t.x);
  const Vec3& p1 = position(t.y);
  const Vec3& p2 = position(t.z);
  const float b0 = 1.F - b1 - b2;
  const Vec3d exact = exact_point(p0, p1, p2, b1, b2);
  point.p = Vec3(exact);
  point.primitive = triangle;

  Vec3 ng = unit_normal(p0, p1, p2);
  if (flip_winding_) ng = -ng;

  // Without coordinates pbrt takes (0,0), (1,0), (1,1).
  Vec2 d1(1.F, 0.F);
  Vec2 d2(1.F, 1.F);
  point.uv = Vec2(b1 + b2, b2);
  if (has_uvs_) {
    const Vec2& uv0 = vertices_[t.x].uv;
    const Vec2& uv1 = vertices_[t.y].uv;
    const Vec2& uv2 = vertices_[t.z].uv;
    d1 = uv1 - uv0;
    d2 = uv2 - uv0;
    point.uv = uv0 * b0 + uv1 * b1 + uv2 * b2;
  }
  point.dpdu = point.dpdv = point.dndu = point.dndv = Vec3(0.F);
  bool has_derivatives = false;
  float scale = 0.F;
  if constexpr (kDerivatives) {
    const Vec3 e1 = p1 - p0;
    const Vec3 e2 = p2 - p0;
    scale = 1.F / (d1.x * d2.y - d1.y * d2.x);
    point.dpdu = (e1 * d2.y - e2 * d1.y) * scale;
    point.dpdv = (e2 * d1.x - e1 * d2.x) * scale;
    const Vec3 area = cross(point.dpdu, point.dpdv);
    has_derivatives = area != Vec3(0.F) && is_finite(area);
    if (!has_derivatives) {
      const Frame frame = Frame::around(ng);
      point.dpdu = frame.x;
      point.dpdv = frame.y;
    }
  }

  point.ns = ng;
  if (has_normals_) {
    const Vec3& n0 = vertices_[t.x].n;
    const Vec3& n1 = vertices_[t.y].n;
    const Vec3& n2 = vertices_[t.z].n;
    const Vec3 n = interpolate(n0, n1, n2, b0, b1, b2);
    const float n_squared = length_squared(n);
    if (n_squared > 1e-30F && n_squared < 1e30F) {
      const float inverse = (reversed_ ? -1.F : 1.F) / std::sqrt(n_squared);
      point.ns = n * inverse;
      ng = face_forward(ng, point.ns);
      if (kDerivatives && has_derivatives) {
        const Vec3 a = (n1 - n0) * inverse;
        const Vec3 b = (n2 - n0) * inverse;
        const Vec3 du = (a * d2.y - b * d1.y) * scale;
        const Vec3 dv = (b * d1.x - a * d2.x) * scale;
        point.dndu = du - point.ns * dot(point.ns, du);
        point.dndv = dv - point.ns * dot(point.ns, dv);
      }
    }
  }
  point.ng = ng;
  if (kDerivatives && tangents_ != nullptr) {
    // The authored tangent gives the direction, the texture coordinates keep the lengths.
    const Vec3 tangent = interpolate(tangents_[t.x], tangents_[t.y], tangents_[t.z], b0, b1, b2);
    const Vec3 along = tangent - point.ns * dot(tangent, point.ns);
    const float along_squared = length_squared(along);
    if (along_squared > 1e-12F * length_squared(tangent) && std::isfinite(along_squared)) {
      const Vec3 x = along / std::sqrt(along_squared);
      const Vec3 across = cross(point.ns, x);
      const float sign = handedness_ == nullptr ? 0.F : handedness(t, b0, b1, b2);
      const Vec3 y = sign == 0.F ? face_forward(across, point.dpdv) : across * sign;
      point.dpdu = x * length(point.dpdu);
      point.dpdv = y * length(point.dpdv);
    }
  }
  return exact;
}

float TriangleMesh::handedness(const Triangle& t, float b0, float b1, float b2) const {
  const float sum = b0 * static_cast<float>(handedness_[t.x]) +
                    b1 * static_cast<float>(handedness_[t.y]) +
                    b2 * static_cast<float>(handedness_[t.z]);
  // A mirrored object is its mirror image, in which cross products have the other sign; and they
  // follow the normal, which a reversed shape has turned around.
  const bool is_turned = reversed_ != mirrors_;
  return sum == 0.F ? 0.F : (sum > 0.F) == is_turned ? -1.F : 1.F;
}

template Vec3d TriangleMesh::find_point<true>(std::uint32_t, float, float, SurfacePoint&) const;
template Vec3d TriangleMesh::find_point<false>(std::uint32_t, float, float, SurfacePoint&) const;

SurfaceDerivatives TriangleMesh::derivatives(std::uint32_t triangle, const Vec3d& p) const {
  const Triangle& t = triangles_[triangle];
  const Vec3d p0(position(t.x));
  const Vec3d e1 = Vec3d(position(t.y)) - p0;
  const Vec3d e2 = Vec3d(position(t.z)) - p0;
  const Vec3d area = e1.cross(e2);
  SurfaceDerivatives result{area.normalized(), e1, e2, Vec3d(0.0), Vec3d(0.0)};
  if (!has_normals_) return result;
  const double squared = area.dot(area);
  const double b1 = (p - p0).cross(e2).dot(area) / squared;
  const double b2 = e1.cross(p - p0).dot(area) / squared;
  const Vec3d n0(vertices_[t.x].n);
  const Vec3d a = Vec3d(vertices_[t.y].n) - n0;
  const Vec3d b = Vec3d(vertices_[t.z].n) - n0;
  const Vec3d n = n0 + a * b1 + b * b2;
  const double size = n.length();
  // Normal of hits: where normals cancel, that of the triangle.
  if (!(size > 1e-15)) return result;
  result.n = n / size;
  const auto of_unit = [&](const Vec3d& dn) { return (dn - result.n * result.n.dot(dn)) / size; };
  result.dndu = of_unit(a);
  result.dndv = of_unit(b);
  return result;
}

double TriangleMesh::triangle_area(std::uint32_t triangle) const {
  const Triangle& t = triangles_[triangle];
  const Vec3d p0(position(t.x));
  return 0.5 * (Vec3d(position(t.y)) - p0).cross(Vec3d(position(t.z)) - p0).length();
}

Vec2 TriangleMesh::barycentric(std::uint32_t triangle, const Vec3d& p) const {
  const Triangle& t = triangles_[triangle];
  const Vec3d p0(position(t.x));
  const Vec3d a = Vec3d(position(t.y)) - p0;
  const Vec3d b = Vec3d(position(t.z)) - p0;
  const Vec3d d = p - p0;
  const Vec3d n = a.cross(b);
  const double squared = n.dot(n);
  return {static_cast<float>(d.cross(b).dot(n) / squared),
          static_cast<float>(a.cross(d).dot(n) / squared)};
}

double TriangleMesh::plane_distance(std::uint32_t triangle, const Vec3d& origin,
                                    const Vec3d& direction) const {
  const Triangle& t = triangles_[triangle];
  const Vec3d p0(position(t.x));
  const Vec3d e1 = Vec3d(position(t.y)) - p0;
  const Vec3d e2 = Vec3d(position(t.z)) - p0;
  const Vec3d n = e1.cross(e2);
  const Vec3d away = p0 - origin;
  const double height = n.dot(away);
  const auto size = [](const Vec3d& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); };
  // Where the roundings of double precision are all that is left: ulps of the products.
  if (std::abs(height) <= 0x1p-50 * size(e1) * size(e2) * size(away)) return 0.0;
  return height / n.dot(direction);
}

}  // namespace ajar
