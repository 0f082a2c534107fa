#include <cmath>

#include "scene/geometry_records.h"

namespace ajar {

namespace {

const QueryContext& query(const RTCIntersectContext* context) {
  return *reinterpret_cast<const QueryContext*>(context);
}

const Placement* instance_of(const QueryContext& context, unsigned id) {
  if (id == RTC_INVALID_GEOMETRY_ID) return nullptr;
  return &*context.instances[id - context.first_instance].placement;
}

enum class Purpose { Intersect, Occlude };

bool is_cut_away(const ShapeRecord& record, const SurfacePoint& point, Purpose purpose) {
  if (record.has_alpha() && record.alpha.eval_float(point) == 0.F) return true;
  return purpose == Purpose::Occlude && record.shadow_alpha.eval_float(point) == 0.F;
}

bool has_cutouts(const ShapeRecord& record, Purpose purpose) {
  return record.has_alpha() || (purpose == Purpose::Occlude && record.has_shadow_alpha());
}

/// True if a hit is farther from both ends of its ray than the error of the triangle test, in the
/// world.
bool is_clear_of_ends(const TriangleMesh& mesh, const RTCRay& ray, const RTCHit& hit, float t_max) {
  const Vec3 n(hit.Ng_x, hit.Ng_y, hit.Ng_z);
  const float slope = dot(n, {ray.dir_x, ray.dir_y, ray.dir_z});
  const float height = std::min(ray.tfar, t_max - ray.tfar) * slope;
  const float error = mesh.plane_error();
  return height * height > error * error * length_squared(n);
}

template <Purpose kPurpose>
void filter_triangle(const RTCFilterFunctionNArguments* args) {
  if (args->valid[0] == 0) return;
  const auto& record = *static_cast<const ShapeRecord*>(args->geometryUserPtr);
  const auto& hit = *reinterpret_cast<const RTCHit*>(args->hit);
  const QueryContext& context = query(args->context);
  const Placement* instance = instance_of(context, hit.instID[0]);
  const auto& traced = *reinterpret_cast<const RTCRay*>(args->ray);
  if (record.check_plane &&
      (instance != nullptr || !is_clear_of_ends(*record.mesh, traced, hit, context.ray->t_max))) {
    // A ray leaves this very triangle if, without rounding, its plane lies behind, and ends at it
    // if it lies beyond.
    const LocalRay ray = to_instance(*context.ray, instance);
    const double t = record.mesh->plane_distance(hit.primID, ray.origin, ray.direction);
    if (t <= 0.0 || t > double{context.ray->t_max}) {
      args->valid[0] = 0;
      return;
    }
  }
  if (!has_cutouts(record, kPurpose)) return;
  SurfacePoint point{};
  const Vec2 b = barycentric_of(*record.mesh, hit, *context.ray, instance);
  record.mesh->texture_point(hit.primID, b.x, b.y, point);
  if (instance != nullptr) point.p = Vec3(instance->point(Vec3d(point.p)));
  if (is_cut_away(record, point, kPurpose)) args->valid[0] = 0;
}

template <Purpose kPurpose>
void filter_curve(const RTCFilterFunctionNArguments* args) {
  if (args->valid[0] == 0) return;
  const auto& record = *static_cast<const ShapeRecord*>(args->geometryUserPtr);
  const auto& hit = *reinterpret_cast<const RTCHit*>(args->hit);
  const auto& ray = *reinterpret_cast<const RTCRay*>(args->ray);
  const Vec3 direction(ray.dir_x, ray.dir_y, ray.dir_z);
  if (ray.tfar * length(direction) < record.curve->self_distance(hit.primID, hit.u)) {
    args->valid[0] = 0;
    return;
  }
  if (!has_cutouts(record, kPurpose)) return;
  SurfacePoint point =
      record.curve->surface_point(hit.primID, hit.u, {ray.org_x, ray.org_y, ray.org_z}, direction,
                                  ray.tfar, {hit.Ng_x, hit.Ng_y, hit.Ng_z});
  const Placement* instance = instance_of(query(args->context), hit.instID[0]);
  if (instance != nullptr) place_point(*instance, Vec3d(point.p), true, point);
  if (is_cut_away(record, point, kPurpose)) args->valid[0] = 0;
}

void quadric_bounds(const RTCBoundsFunctionArguments* args) {
  const auto& record = *static_cast<const ShapeRecord*>(args->geometryUserPtr);
  Vec3d low;
  Vec3d high;
  placed_bounds(*record.quadric, *record.placement, low, high);
  float* lower[3] = {&args->bounds_o->lower_x, &args->bounds_o->lower_y, &args->bounds_o->lower_z};
  float* upper[3] = {&args->bounds_o->upper_x, &args->bounds_o->upper_y, &args->bounds_o->upper_z};
  for (int i = 0; i < 3; ++i) {
    // Wide enough that single-precision traversal cannot miss hits in double precision.
    const double margin = 1e-6 * std::max(std::abs(low[i]), std::abs(high[i])) + 1e-30;
    *lower[i] = static_cast<float>(low[i] - margin);
    *upper[i] = static_cast<float>(high[i] + margin);
  }
}

/// True if a root is the origin of the ray itself, as far as double precision can tell from the
/// size of the shape: all that is left of a large sphere where it touches the origin of the world.
bool is_own_start(const ShapeRecord& record, const LocalRay& ray, double t) {
  constexpr double kNear = 0x1p-20;
  constexpr double kRounding = 0x1p-46;
  const double size = ray.origin.length();
  if (!(std::abs(t) * ray.direction.length() < kNear * size)) return false;
  const Vec3d p = record.quadric->project(ray.origin + ray.direction * t);
  const Vec3d n = record.quadric->at(record.quadric->parameters(p)).n;
  return std::abs(t * n.dot(ray.direction)) <= kRounding * size;
}

/// First root in (near, far] that is not cut away; NaN if there is none.
template <Purpose kPurpose>
float first_root(const ShapeRecord& record, const QueryContext& context, unsigned instance_id,
                 float near, float far) {
  const Placement* instance = instance_of(context, instance_id);
  const LocalRay ray = to_shape(to_instance(*context.ray, instance), *record.placement);
  const Quadric::Roots roots = record.quadric->intersect(ray.origin, ray.direction);
  for (int i = 0; i < roots.count; ++i) {
    const auto t = static_cast<float>(roots.t[i]);
    if (!(t > near && t <= far) || is_own_start(record, ray, roots.t[i])) continue;
    if (has_cutouts(record, kPurpose)) {
      const Vec3d p = record.quadric->project(ray.origin + ray.direction * roots.t[i]);
      SurfacePoint point = quadric_surface_point(*record.quadric, *record.placement,
                                                 record.reversed, record.quadric->parameters(p));
      if (instance != nullptr) place_point(*instance, Vec3d(point.p), true, point);
      if (is_cut_away(record, point, kPurpose)) continue;
    }
    return t;
  }
  return std::numeric_limits<float>::quiet_NaN();
}

void intersect_quadric(const RTCIntersectFunctionNArguments* args) {
  if (args->valid[0] == 0) return;
  const auto& record = *static_cast<const ShapeRecord*>(args->geometryUserPtr);
  auto& rayhit = *reinterpret_cast<RTCRayHit*>(args->rayhit);
  const unsigned instance = args->context->instID[0];
  const float t = first_root<Purpose::Intersect>(record, query(args->context), instance,
                                                 rayhit.ray.tnear, rayhit.ray.tfar);
  if (std::isnan(t)) return;
  rayhit.ray.tfar = t;
  rayhit.hit.u = rayhit.hit.v = 0.F;
  rayhit.hit.primID = args->primID;
  rayhit.hit.geomID = args->geomID;
  rayhit.hit.instID[0] = instance;
}

void occlude_quadric(const RTCOccludedFunctionNArguments* args) {
  if (args->valid[0] == 0) return;
  const auto& record = *static_cast<const ShapeRecord*>(args->geometryUserPtr);
  auto& ray = *reinterpret_cast<RTCRay*>(args->ray);
  const float t = first_root<Purpose::Occlude>(record, query(args->context),
                                               args->context->instID[0], ray.tnear, ray.tfar);
  if (!std::isnan(t)) ray.tfar = -std::numeric_limits<float>::infinity();
}

}  // namespace

void placed_bounds(const Quadric& quadric, const Placement& placement, Vec3d& low, Vec3d& high) {
  Vec3d own_low;
  Vec3d own_high;
  quadric.bounds(own_low, own_high);
  low = Vec3d(std::numeric_limits<double>::infinity());
  high = -low;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3d p = placement.point({(corner & 1) != 0 ? own_high.x : own_low.x,
                                     (corner & 2) != 0 ? own_high.y : own_low.y,
                                     (corner & 4) != 0 ? own_high.z : own_low.z});
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  }
  if (const auto radius = quadric.full_sphere_radius()) {
    // The tight box of an ellipsoid: half its width is the length of a column of the matrix.
    const Vec3d center = placement.point(Vec3d(0.0));
    const Mat4& m = placement.to_world();
    for (int i = 0; i < 3; ++i) {
      const double half =
          *radius * std::sqrt(m[0][i] * m[0][i] + m[1][i] * m[1][i] + m[2][i] * m[2][i]);
      low[i] = std::max(low[i], center[i] - half);
      high[i] = std::min(high[i], center[i] + half);
    }
  }
}

void place_point(const Placement& instance, const Vec3d& p, bool derivatives, SurfacePoint& point) {
  const Vec3d n = instance.normal(Vec3d(point.ns));
  const double size = n.length();
  const Vec3d ns = n / size;
  point.p = Vec3(instance.point(p));
  point.ns = Vec3(ns);
  point.ng = face_forward(Vec3(instance.normal(Vec3d(point.ng)).normalized()), point.ns);
  if (!derivatives) return;
  const auto normal_derivative = [&](const Vec3& dn) {
    const Vec3d moved = instance.normal(Vec3d(dn)) / size;
    return Vec3(moved - ns * ns.dot(moved));
  };
  point.dndu = normal_derivative(point.dndu);
  point.dndv = normal_derivative(point.dndv);
  point.dpdu = Vec3(instance.vector(Vec3d(point.dpdu)));
  point.dpdv = Vec3(instance.vector(Vec3d(point.dpdv)));
}

void set_callbacks(RTCGeometry geometry, ShapeRecord& record) {
  rtcSetGeometryUserData(geometry, &record);
  if (record.quadric) {
    rtcSetGeometryUserPrimitiveCount(geometry, 1);
    rtcSetGeometryBoundsFunction(geometry, quadric_bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect_quadric);
    rtcSetGeometryOccludedFunction(geometry, occlude_quadric);
  } else if (record.curve) {
    rtcSetGeometryIntersectFilterFunction(geometry, filter_curve<Purpose::Intersect>);
    rtcSetGeometryOccludedFilterFunction(geometry, filter_curve<Purpose::Occlude>);
  } else {
    if (record.has_alpha() || record.check_plane) {
      rtcSetGeometryIntersectFilterFunction(geometry, filter_triangle<Purpose::Intersect>);
    }
    if (record.has_alpha() || record.has_shadow_alpha() || record.check_plane) {
      rtcSetGeometryOccludedFilterFunction(geometry, filter_triangle<Purpose::Occlude>);
    }
  }
}

}  // namespace ajar
