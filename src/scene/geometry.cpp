#include "scene/geometry.h"

#include <algorithm>
#include <cmath>

#include "scene/geometry_records.h"
#include "scene/shape/make_surface_sampler.h"
#include "scene/surface_derivatives.h"

namespace ajar {

namespace {

RTCRay embree_ray(const Ray& ray) {
  RTCRay result;
  result.org_x = ray.origin.x;
  result.org_y = ray.origin.y;
  result.org_z = ray.origin.z;
  // Beyond 0: rays may start in the plane of a triangle.
  result.tnear = std::numeric_limits<float>::min();
  result.dir_x = ray.direction.x;
  result.dir_y = ray.direction.y;
  result.dir_z = ray.direction.z;
  result.time = 0.F;
  result.tfar = ray.t_max;
  result.mask = 0xffffffffU;
  result.id = 0;
  result.flags = 0;
  return result;
}

/// Embree reported only that and roughly where the quadric is met; this repeats it in double
/// precision. Returns the place before it is rounded.
Vec3d quadric_hit_point(const ShapeRecord& record, const LocalRay& world, float t,
                        SurfacePoint& point) {
  const LocalRay ray = to_shape(world, *record.placement);
  const Quadric::Roots roots = record.quadric->intersect(ray.origin, ray.direction);
  double exact = t;
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < roots.count; ++i) {
    const double difference = std::abs(roots.t[i] - double{t});
    if (difference < nearest) {
      nearest = difference;
      exact = roots.t[i];
    }
  }
  const Vec3d p = record.quadric->project(ray.origin + ray.direction * exact);
  if (!record.derivatives && record.quadric->is_sphere()) {
    point = sphere_plain_point(*record.quadric, *record.placement, record.reversed, p);
  } else {
    point = quadric_surface_point(*record.quadric, *record.placement, record.reversed,
                                  record.quadric->parameters(p));
  }
  return record.placement->point(p);
}

}  // namespace

Geometry::~Geometry() = default;

bool Geometry::intersect(const Ray& ray, GeometryHit& hit) const {
  if (ray.t_max <= 0.F || !can_trace(ray)) return false;
  if (ray_log_ != nullptr) ray_log_->entries.push_back({ray, false});
  QueryContext context = make_context(ray);
  RTCRayHit rayhit;
  rayhit.ray = embree_ray(ray);
  rayhit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rayhit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(top_.get(), &context.embree, &rayhit);
  if (rayhit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;

  hit.t = rayhit.ray.tfar;
  hit.shape = rayhit.hit.geomID;
  hit.instance_id = 0;
  const Placement* instance = nullptr;
  if (rayhit.hit.instID[0] != RTC_INVALID_GEOMETRY_ID) {
    const unsigned index = rayhit.hit.instID[0] - context.first_instance;
    instance = &*instances_[index].placement;
    hit.instance_id = index + 1;
    hit.shape += static_cast<std::uint32_t>(object_base_[instances_[index].object]);
  }
  const ShapeRecord& record = shapes_[hit.shape];
  Vec3d p;
  if (record.mesh) {
    const Vec2 b = barycentric_of(*record.mesh, rayhit.hit, ray, instance);
    p = record.derivatives ? record.mesh->surface_point(rayhit.hit.primID, b.x, b.y, hit.point)
                           : record.mesh->plain_point(rayhit.hit.primID, b.x, b.y, hit.point);
  } else if (record.quadric) {
    p = quadric_hit_point(record, to_instance(ray, instance), hit.t, hit.point);
  } else {
    const LocalRay local = to_instance(ray, instance);
    hit.point = record.curve->surface_point(rayhit.hit.primID, rayhit.hit.u, Vec3(local.origin),
                                            Vec3(local.direction), hit.t,
                                            {rayhit.hit.Ng_x, rayhit.hit.Ng_y, rayhit.hit.Ng_z});
    p = Vec3d(hit.point.p);
  }
  if (instance != nullptr) place_point(*instance, p, record.derivatives, hit.point);
  hit.cut_away = record.has_counted_alpha() && record.alpha.eval_float(hit.point) == 0.F;
  return true;
}

std::optional<SurfaceDerivatives> Geometry::derivatives(const GeometryHit& hit) const {
  const ShapeRecord& record = shapes_[hit.shape];
  const Placement* instance =
      hit.instance_id == 0 ? nullptr : &*instances_[hit.instance_id - 1].placement;
  Vec3d p(hit.point.p);
  if (instance != nullptr) p = instance->point_to_object(p);
  std::optional<SurfaceDerivatives> result;
  if (record.mesh) {
    result = record.mesh->derivatives(hit.point.primitive, p);
  } else if (record.quadric) {
    const Quadric& quadric = *record.quadric;
    const Vec3d on_surface = quadric.project(record.placement->point_to_object(p));
    const Quadric::Point at = quadric.at(quadric.parameters(on_surface));
    result = placed({at.n, at.dpdu, at.dpdv, at.dndu, at.dndv}, *record.placement);
  } else {
    result = record.curve->derivatives(hit.point.primitive, double{hit.point.uv.x}, p);
  }
  if (!result) return result;
  if (instance != nullptr) result = placed(*result, *instance);
  if (!is_usable(*result)) return std::nullopt;
  if (result->n.dot(Vec3d(hit.point.ns)) < 0.0) {
    result->n = -result->n;
    result->dndu = -result->dndu;
    result->dndv = -result->dndv;
  }
  return result;
}

bool Geometry::occluded(const Ray& ray) const {
  if (ray.t_max <= 0.F) return false;
  if (!can_trace(ray)) return true;
  if (ray_log_ != nullptr) ray_log_->entries.push_back({ray, true});
  QueryContext context = make_context(ray);
  RTCRay query = embree_ray(ray);
  rtcOccluded1(top_.get(), &context.embree, &query);
  return query.tfar < 0.F;
}

void Geometry::replay(const RayLog& log) const {
  for (const RayLog::Entry& entry : log.entries) {
    QueryContext context = make_context(entry.ray);
    if (entry.occlusion) {
      RTCRay query = embree_ray(entry.ray);
      rtcOccluded1(top_.get(), &context.embree, &query);
    } else {
      RTCRayHit rayhit;
      rayhit.ray = embree_ray(entry.ray);
      rayhit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      rayhit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(top_.get(), &context.embree, &rayhit);
    }
  }
}

QueryContext Geometry::make_context(const Ray& ray) const {
  QueryContext context;
  rtcInitIntersectContext(&context.embree);
  context.ray = &ray;
  context.instances = instances_.data();
  context.first_instance = static_cast<unsigned>(object_base_.front());
  return context;
}

void Geometry::leave_out_derivatives(std::size_t shape) { shapes_[shape].derivatives = false; }
std::size_t Geometry::shape_count() const { return shapes_.size(); }
bool Geometry::has_shape(std::size_t shape) const { return shapes_[shape].present(); }

bool Geometry::has_place_of(const GeometryHit& hit) const {
  if (hit.shape >= shapes_.size() || hit.instance_id > instances_.size()) return false;
  if (hit.instance_id == 0) {
    if (hit.shape >= object_base_.front()) return false;
  } else {
    const InstanceRecord& instance = instances_[hit.instance_id - 1];
    if (!instance.placement || hit.shape < object_base_[instance.object] ||
        hit.shape >= object_base_[instance.object + 1]) {
      return false;
    }
  }
  const ShapeRecord& record = shapes_[hit.shape];
  if (record.mesh) return hit.point.primitive < record.mesh->triangle_count();
  if (record.curve) return hit.point.primitive < record.curve->segment_count();
  return record.quadric.has_value();
}

std::unique_ptr<SurfaceSampler> Geometry::make_sampler(std::size_t shape) const {
  const ShapeRecord& record = shapes_[shape];
  if (record.mesh) return make_surface_sampler(*record.mesh);
  if (record.quadric)
    return make_surface_sampler(*record.quadric, *record.placement, record.reversed);
  return nullptr;
}

}  // namespace ajar
