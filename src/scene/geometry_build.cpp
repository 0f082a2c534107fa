#include <algorithm>
#include <cmath>

#include "core/number_text.h"
#include "core/parallel_for.h"
#include "scene/geometry.h"
#include "scene/geometry_records.h"
#include "scene/instance_space.h"
#include "scene/shape/build_shape.h"

namespace ajar {

namespace {

constexpr WarningKind kCutAway{Effect::None, "shapes are cut away whole by their alpha"};
constexpr WarningKind kSingularShape{Effect::Geometry,
                                     "shapes have singular transforms and are left out"};
constexpr WarningKind kSingularInstance{Effect::Geometry,
                                        "instances have singular transforms and are left out"};

bool count_memory(void* counter, ssize_t bytes, bool /*post*/) {
  static_cast<std::atomic<std::int64_t>*>(counter)->fetch_add(bytes, std::memory_order_relaxed);
  return true;
}

void check(RTCDevice device, const SourceLocation& where) {
  switch (rtcGetDeviceError(device)) {
    case RTC_ERROR_NONE:
      return;
    case RTC_ERROR_OUT_OF_MEMORY:
      throw SceneError(where, "there is not enough memory for the geometry of the scene");
    default:
      throw SceneError(where, "Embree cannot build the geometry of the scene");
  }
}

/// Puts the built shape into its record.
struct RecordFilling {
  ShapeRecord& record;
  const SourceLocation& where;

  void operator()(std::monostate) const {}
  void operator()(std::unique_ptr<const TriangleMesh>& mesh) const {
    record.check_plane = mesh->plane_error() > 0.F;
    record.mesh = std::move(mesh);
  }
  void operator()(std::unique_ptr<const CurveShape>& curve) const {
    record.curve = std::move(curve);
  }
  void operator()(const Quadric& quadric) const {
    record.quadric = quadric;
    Vec3d low;
    Vec3d high;
    placed_bounds(quadric, *record.placement, low, high);
    check_reach(where, "the shape", reach_of(low, high));
  }
};

TextureSlot alpha_slot(desc::TextureId id, const TextureList& textures) {
  if (id < 0) return TextureSlot(Spectrum(1.F));
  return TextureSlot(textures.at(static_cast<std::size_t>(id)).get());
}

void prepare(desc::Shape& shape, const TextureList& textures, Warnings& warnings,
             ShapeRecord& record) {
  record.alpha = alpha_slot(shape.alpha, textures);
  record.shadow_alpha = alpha_slot(shape.shadow_alpha, textures);
  record.alpha_counted = shape.alpha_counted;
  record.reversed = shape.reverse_orientation;
  if (record.alpha.is_constant() && record.alpha.eval_float(SurfacePoint{}) == 0.F) {
    warnings.add(kCutAway, shape.where, "alpha is zero everywhere; the shape is left out");
    return;
  }
  record.placement = Placement::make(shape.to_world);
  if (!record.placement) {
    warnings.add(kSingularShape, shape.where,
                 "the transform of the shape is singular; it is left out");
    return;
  }
  BuiltShape built = build_shape(shape, *record.placement, warnings);
  std::visit(RecordFilling{record, shape.where}, built);
}

/// Instances are placed by Embree in single precision, so the same rounded matrix is used
/// everywhere.
Mat4 rounded(const Mat4& m) {
  Mat4 result;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) result[i][j] = static_cast<float>(m[i][j]);
  }
  return result;
}

RTCGeometry make_triangles(RTCDevice device, const TriangleMesh& mesh) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                             mesh.positions(), 0, mesh.position_stride(), mesh.vertex_count());
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.triangles(),
                             0, sizeof(TriangleMesh::Triangle), mesh.triangle_count());
  return geometry;
}

RTCGeometry make_curves(RTCDevice device, const CurveShape& curve) {
  RTCGeometryType type = RTC_GEOMETRY_TYPE_FLAT_BEZIER_CURVE;
  if (curve.type() == CurveShape::Type::Cylinder) type = RTC_GEOMETRY_TYPE_ROUND_BEZIER_CURVE;
  if (curve.type() == CurveShape::Type::Ribbon)
    type = RTC_GEOMETRY_TYPE_NORMAL_ORIENTED_BEZIER_CURVE;
  RTCGeometry geometry = rtcNewGeometry(device, type);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                             curve.vertices(), 0, 4 * sizeof(float), curve.vertex_count());
  if (curve.type() == CurveShape::Type::Ribbon) {
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_NORMAL, 0, RTC_FORMAT_FLOAT3,
                               curve.normals(), 0, sizeof(Vec3), curve.vertex_count());
  }
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT,
                             curve.first_vertices(), 0, sizeof(unsigned), curve.segment_count());
  return geometry;
}

/// Empty if there is nothing.
Box3 bounds_of(RTCScene scene) {
  RTCBounds box;
  rtcGetSceneBounds(scene, &box);
  const Vec3 low(box.lower_x, box.lower_y, box.lower_z);
  const Vec3 high(box.upper_x, box.upper_y, box.upper_z);
  return is_finite(low) && is_finite(high) && low.x <= high.x ? Box3(low, high) : Box3();
}

/// The box of a placed box: half its width is that of the box times the absolute matrix.
void placed_bounds(const Box3& box, const Placement& placement, Vec3d& low, Vec3d& high) {
  const Vec3d half = (Vec3d(box.max) - Vec3d(box.min)) * 0.5;
  const Vec3d center = placement.point(Vec3d(box.min) + half);
  Vec3d placed_half(0.0);
  for (int row = 0; row < 3; ++row) {
    for (int k = 0; k < 3; ++k) {
      placed_half[k] += half[row] * std::abs(placement.to_world()[row][k]);
    }
  }
  low = center - placed_half;
  high = center + placed_half;
}

void extend(Box3& box, const ShapeRecord& shape) {
  if (shape.mesh) {
    const char* position = reinterpret_cast<const char*>(shape.mesh->positions());
    for (std::size_t i = 0; i < shape.mesh->vertex_count(); ++i) {
      box.extendBy(*reinterpret_cast<const Vec3*>(position));
      position += shape.mesh->position_stride();
    }
  } else if (shape.curve) {
    // Bézier curves lie among their control points.
    for (std::size_t i = 0; i < shape.curve->vertex_count(); ++i) {
      const auto& [x, y, z, radius] = shape.curve->vertices()[i];
      box.extendBy(Vec3(x - radius, y - radius, z - radius));
      box.extendBy(Vec3(x + radius, y + radius, z + radius));
    }
  } else if (shape.quadric) {
    Vec3d low;
    Vec3d high;
    placed_bounds(*shape.quadric, *shape.placement, low, high);
    box.extendBy(Vec3(low));
    box.extendBy(Vec3(high));
  }
}

void attach(RTCScene scene, RTCGeometry geometry, std::size_t id) {
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, static_cast<unsigned>(id));
  rtcReleaseGeometry(geometry);
}

}  // namespace

void Geometry::Release::operator()(RTCDeviceTy* device) const { rtcReleaseDevice(device); }
void Geometry::Release::operator()(RTCSceneTy* scene) const { rtcReleaseScene(scene); }

Geometry::Geometry(desc::SceneDesc& description, const TextureList& textures, Warnings& warnings)
    : where_{std::make_shared<const std::string>(description.source)},
      embree_bytes_(std::make_unique<std::atomic<std::int64_t>>(0)),
      device_(rtcNewDevice(nullptr)) {
  if (!device_) throw SceneError(where_, "Embree cannot be started");
  rtcSetDeviceMemoryMonitorFunction(device_.get(), count_memory, embree_bytes_.get());
  prepare_instances(description, warnings);
  prepare_shapes(description, textures, warnings);
  for (std::size_t object = 0; object + 1 < object_base_.size(); ++object) {
    const std::size_t first = object_base_[object];
    const bool used =
        std::any_of(instances_.begin(), instances_.end(),
                    [&](const InstanceRecord& i) { return i.placement && i.object == object; });
    objects_.push_back(used ? commit(first, object_base_[object + 1] - first, false) : nullptr);
  }
  const std::vector<Box3> instances = instance_boxes();
  check_instances(description, instances);
  find_receivers(description, instances);
  top_ = commit(0, object_base_.front(), true);
  count(description.objects.size());
}

void Geometry::prepare_instances(const desc::SceneDesc& description, Warnings& warnings) {
  object_base_.push_back(description.shapes.size());
  for (const desc::Object& object : description.objects) {
    object_base_.push_back(object_base_.back() + object.shapes.size());
  }
  for (const desc::Instance& instance : description.instances) {
    if (instance.object < 0 || instance.object >= static_cast<int>(description.objects.size())) {
      throw SceneError(instance.where, "an instance refers to an object that does not exist");
    }
    InstanceRecord& record = instances_.emplace_back();
    record.object = static_cast<std::size_t>(instance.object);
    record.placement = Placement::make(rounded(instance.to_world));
    if (record.placement && !max_ray_coordinate(*record.placement)) record.placement.reset();
    if (!record.placement) {
      warnings.add(kSingularInstance, instance.where,
                   "the transform of the instance is singular; it is left out");
    }
  }
}

void Geometry::prepare_shapes(desc::SceneDesc& description, const TextureList& textures,
                              Warnings& warnings) {
  std::vector<char> is_used(description.objects.size(), 0);
  for (const InstanceRecord& instance : instances_) {
    if (instance.placement) is_used[instance.object] = 1;
  }
  std::vector<desc::Shape*> todo;
  for (desc::Shape& shape : description.shapes) todo.push_back(&shape);
  for (std::size_t i = 0; i < description.objects.size(); ++i) {
    for (desc::Shape& shape : description.objects[i].shapes) {
      todo.push_back(is_used[i] != 0 ? &shape : nullptr);
    }
  }
  shapes_ = std::vector<ShapeRecord>(todo.size());
  // Threads meet them in any order; the file has one.
  std::vector<std::unique_ptr<const Warnings>> of_shapes(todo.size());
  parallel_for(todo.size(), [&](std::size_t i) {
    if (todo[i] == nullptr) return;
    auto own = std::make_unique<Warnings>(Warnings::kAll);
    prepare(*todo[i], textures, *own, shapes_[i]);
    if (own->count() > 0) of_shapes[i] = std::move(own);
  });
  for (const auto& own : of_shapes) {
    if (own) warnings.add_all(*own);
  }
  // Embree transforms rays into an instance in single precision, with an error of some roundings of
  // its place.
  for (std::size_t k = object_base_.front(); k < shapes_.size(); ++k) {
    shapes_[k].check_plane = shapes_[k].mesh != nullptr;
  }
}

Geometry::SceneHandle Geometry::commit(std::size_t first, std::size_t shape_count,
                                       bool with_instances) const {
  SceneHandle scene(rtcNewScene(device_.get()));
  for (std::size_t i = 0; i < shape_count; ++i) {
    // Embree keeps the address for its callbacks, which only read.
    auto& record = const_cast<ShapeRecord&>(shapes_[first + i]);
    if (!record.present()) continue;
    RTCGeometry geometry = nullptr;
    if (record.mesh) {
      geometry = make_triangles(device_.get(), *record.mesh);
    } else if (record.curve) {
      geometry = make_curves(device_.get(), *record.curve);
    } else {
      geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_USER);
    }
    set_callbacks(geometry, record);
    attach(scene.get(), geometry, i);
  }
  for (std::size_t i = 0; with_instances && i < instances_.size(); ++i) {
    if (!instances_[i].placement) continue;
    RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(geometry, objects_[instances_[i].object].get());
    const Mat4& m = instances_[i].placement->to_world();
    float columns[12];
    for (int row = 0; row < 4; ++row) {
      for (int k = 0; k < 3; ++k) columns[3 * row + k] = static_cast<float>(m[row][k]);
    }
    rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
    attach(scene.get(), geometry, shape_count + i);
  }
  // Without this flag one ray in a million slips between triangles of a closed mesh (measured),
  // which shows where a dark room is next to a bright one. It costs 10 to 20 % of the pure ray
  // casting time.
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  rtcCommitScene(scene.get());
  check(device_.get(), where_);
  return scene;
}

std::vector<Box3> Geometry::instance_boxes() const {
  std::vector<Box3> boxes(instances_.size());
  for (std::size_t i = 0; i < instances_.size(); ++i) {
    if (!instances_[i].placement) continue;
    const Box3 box = bounds_of(objects_[instances_[i].object].get());
    if (box.isEmpty()) continue;
    Vec3d low;
    Vec3d high;
    placed_bounds(box, *instances_[i].placement, low, high);
    boxes[i] = Box3(Vec3(low), Vec3(high));
  }
  return boxes;
}

void Geometry::check_instances(const desc::SceneDesc& description, const std::vector<Box3>& boxes) {
  for (std::size_t i = 0; i < instances_.size(); ++i) {
    if (!instances_[i].placement) continue;
    const double limit = *max_ray_coordinate(*instances_[i].placement);
    max_ray_coordinate_ = std::min(max_ray_coordinate_, static_cast<float>(limit));
    check_reach(description.instances[i].where, "the instance", reach_of(boxes[i]));
  }
}

void Geometry::find_receivers(const desc::SceneDesc& description,
                              const std::vector<Box3>& instances) {
  for (std::size_t i = 0; i < description.shapes.size(); ++i) {
    if (!description.shapes[i].emission) extend(receivers_, shapes_[i]);
  }
  for (const Box3& box : instances) receivers_.extendBy(box);
}

void Geometry::require_reach(double reach, const desc::SceneDesc& description) const {
  if (reach < static_cast<double>(max_ray_coordinate_)) return;
  for (std::size_t i = 0; i < instances_.size(); ++i) {
    if (!instances_[i].placement) continue;
    const double limit = *max_ray_coordinate(*instances_[i].placement);
    if (reach < limit) continue;
    const std::string why = limit > 0.0
                                ? "its scene has rays that start at coordinates of " +
                                      number_text(reach) + ", but only from " + number_text(limit) +
                                      " can they be brought into its space"
                                : "its transform cannot be inverted in single precision";
    throw SceneError(description.instances[i].where,
                     "the instance is scaled too much: " + why + "; scale its shapes instead");
  }
}

void Geometry::count(std::size_t object_count) {
  std::vector<std::size_t> triangles(object_count + 1, 0);
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    const auto above = std::upper_bound(object_base_.begin(), object_base_.end(), i);
    const auto group = static_cast<std::size_t>(above - object_base_.begin());
    if (shapes_[i].mesh) triangles[group] += shapes_[i].mesh->triangle_count();
    if (shapes_[i].quadric) ++counts_.quadrics;
    if (shapes_[i].curve) counts_.curves += shapes_[i].curve->segment_count();
  }
  for (const std::size_t n : triangles) counts_.triangles += n;
  counts_.instanced_triangles = triangles[0];
  for (const InstanceRecord& instance : instances_) {
    if (!instance.placement) continue;
    ++counts_.instances;
    counts_.instanced_triangles += triangles[instance.object + 1];
  }
  counts_.embree_bytes = static_cast<std::size_t>(std::max<std::int64_t>(0, embree_bytes_->load()));
  bounds_ = bounds_of(top_.get());
}

}  // namespace ajar
