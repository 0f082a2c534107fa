#pragma once
#include <memory>
#include <vector>

#include "core/error.h"
#include "core/spectrum.h"
#include "core/warnings.h"
#include "scene/desc/scene_desc.h"
#include "scene/shape/placement.h"
#include "scene/surface_derivatives.h"
#include "scene/surface_point.h"

namespace ajar {

/// Triangles in their final place, laid out so that Embree can share the buffers. Immutable.
class TriangleMesh {
 public:
  using Triangle = Imath::Vec3<unsigned>;

  /// Takes over `source` if it is uniquely owned (the mesh must not have been created const);
  /// otherwise only what the transform changes is copied. Raises SceneError, located at `where`,
  /// for indices out of range, and for vertices too far out and triangles too large to be traced;
  /// attributes of the wrong number are dropped with a warning.
  TriangleMesh(std::shared_ptr<const desc::Mesh> source, const Placement& placement, bool reversed,
               const SourceLocation& where, Warnings& warnings);

  std::size_t triangle_count() const { return triangle_count_; }
  std::size_t vertex_count() const { return vertex_count_; }
  /// Position of vertex 0; the others follow every `position_stride` bytes, and 16 bytes may be
  /// read at each of them.
  const Vec3* positions() const { return positions_; }
  std::size_t position_stride() const { return stride_; }
  const Triangle* triangles() const { return triangles_; }

  /// Point with barycentric coordinates (1 − b1 − b2, b1, b2). Normals as in pbrt-v3: authored
  /// normals decide on which side `ng` lies, the winding only where there are none. Returns the
  /// place before it is rounded.
  Vec3d surface_point(std::uint32_t triangle, float b1, float b2, SurfacePoint& point) const {
    return find_point<true>(triangle, b1, b2, point);
  }
  /// Surface point with all derivatives zero.
  Vec3d plain_point(std::uint32_t triangle, float b1, float b2, SurfacePoint& point) const {
    return find_point<false>(triangle, b1, b2, point);
  }
  /// Only position and texture coordinates.
  void texture_point(std::uint32_t triangle, float b1, float b2, SurfacePoint& point) const;
  /// By barycentric coordinates, around a point `p` in the plane of a triangle; authored tangents
  /// do not count. Not usable if the triangle has no area.
  SurfaceDerivatives derivatives(std::uint32_t triangle, const Vec3d& p) const;
  double triangle_area(std::uint32_t triangle) const;
  /// (b1, b2) of a point in the plane of a triangle that has an area.
  Vec2 barycentric(std::uint32_t triangle, const Vec3d& p) const;
  Vec2 barycentric(std::uint32_t triangle, const Vec3& p) const {
    return barycentric(triangle, Vec3d(p));
  }
  /// The most by which a single-precision plane test errs for triangles where `offset_ray_origin`
  /// moves points by less: those that are not parallel to an axis and whose plane passes the origin
  /// within some of their own size. 0 if there are none.
  float plane_error() const { return plane_error_; }
  /// Ray parameter of the plane of a triangle in double precision; 0 for rays that start in the
  /// plane up to rounding, infinite if parallel.
  double plane_distance(std::uint32_t triangle, const Vec3d& origin, const Vec3d& direction) const;

 private:
  /// Vertex data that a hit reads, in one cache line.
  struct alignas(32) Vertex {
    Vec3 p;
    Vec3 n;
    Vec2 uv;
  };

  /// Transforms the vertices. If the source is `unique`, in its own memory or instead of it.
  void place(const Placement& placement, bool unique);
  void place_with_attributes(const Placement& placement);
  const Vec3& position(std::size_t vertex) const {
    return *reinterpret_cast<const Vec3*>(reinterpret_cast<const char*>(positions_) +
                                          vertex * stride_);
  }
  template <bool kDerivatives>
  Vec3d find_point(std::uint32_t triangle, float b1, float b2, SurfacePoint& point) const;
  void validate(const SourceLocation& where);

  std::shared_ptr<const desc::Mesh> source_;
  std::vector<Vertex>
      vertices_;  ///< empty if vertices have neither normals nor texture coordinates
  std::vector<Vec3> own_positions_;
  std::vector<Vec3> own_tangents_;
  const Vec3* positions_ = nullptr;
  std::size_t stride_ = sizeof(Vec3);
  const Vec3* tangents_ = nullptr;
  /// 1 or −1, in the world; 0: as the texture coordinates have it.
  float handedness(const Triangle& t, float b0, float b1, float b2) const;

  const std::int8_t* handedness_ = nullptr;
  const Triangle* triangles_ = nullptr;
  std::size_t vertex_count_ = 0;
  std::size_t triangle_count_ = 0;
  bool has_normals_ = false;
  bool has_uvs_ = false;
  bool flip_winding_ = false;  ///< the geometric normal is against the winding
  bool reversed_ = false;
  float plane_error_ = 0.F;
  bool mirrors_ = false;  ///< its placement does
};

}  // namespace ajar
