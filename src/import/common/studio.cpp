#include "import/common/studio.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "import/common/degree.h"
#include "scene/desc/models.h"

namespace ajar {
namespace {

/// Direction of the camera: from the front, the right, and above. High enough that the table
/// reaches beyond the upper edge of the picture.
constexpr double kAzimuth = 35.0 * kDegree;
constexpr double kElevation = 24.0 * kDegree;
constexpr double kFov = 30.0;     ///< across the shorter side, degrees
constexpr double kMargin = 1.12;  ///< times the distance at which the model just fits

/// A disk that shines towards the model, in radii of the model; radiance of its light.
struct Softbox {
  double azimuth, elevation, distance, radius;
  float radiance;
};
constexpr Softbox kKey{-40.0 * kDegree, 55.0 * kDegree, 5.0, 1.0, 19.F};
constexpr Softbox kRim{160.0 * kDegree, 35.0 * kDegree, 6.0, 0.9, 9.F};
constexpr float kSky = 0.3F;
constexpr float kTable = 0.55F;        ///< reflectance
constexpr double kTableRadius = 60.0;  ///< in radii of the model
constexpr double kGapBelow = 1e-4;     ///< flat bottoms do not touch the table

Imath::Box3d box_of(const desc::Mesh& mesh) {
  Imath::Box3d box;
  for (const Imath::Vec3<unsigned>& t : mesh.indices) {
    for (const unsigned i : {t.x, t.y, t.z}) box.extendBy(Vec3d(mesh.positions[i]));
  }
  return box;
}

/// Their control points hold them, but for their width.
Imath::Box3d box_of(const desc::Curves& curves) {
  Imath::Box3d box;
  for (const Vec3& point : curves.control_points) box.extendBy(Vec3d(point));
  return box;
}

/// Bounding box of a sphere, disk or cylinder; partial sweeps count as full turns.
Imath::Box3d box_of_quadric(const desc::Node& node) {
  const double radius = node.number("radius");
  const auto z = [&](const char* name, double otherwise) {
    if (node.is("disk")) return static_cast<double>(node.number("height"));
    const float* given = node.has(name) ? std::get_if<float>(&node.get(name)) : nullptr;
    return given == nullptr ? otherwise : static_cast<double>(*given);
  };
  return {{-radius, -radius, z("z_min", -radius)}, {radius, radius, z("z_max", radius)}};
}

std::array<Vec3d, 8> corners_of(const Imath::Box3d& box) {
  std::array<Vec3d, 8> corners;
  for (std::size_t i = 0; i < 8; ++i) {
    corners[i] = Vec3d((i & 1U) != 0 ? box.max.x : box.min.x, (i & 2U) != 0 ? box.max.y : box.min.y,
                       (i & 4U) != 0 ? box.max.z : box.min.z);
  }
  return corners;
}

/// The boxes of shapes that have one, each in its own space and with its place. The scene must not
/// change meanwhile.
class PlacedBoxes {
 public:
  explicit PlacedBoxes(const desc::SceneDesc& scene) {
    for (const desc::Shape& shape : scene.shapes) add(local_box(shape), shape.to_world);
    std::vector<Imath::Box3d> objects;
    for (const desc::Object& object : scene.objects) {
      Imath::Box3d& box = objects.emplace_back();
      for (const desc::Shape& shape : object.shapes) {
        visit_corners({local_box(shape), &shape.to_world},
                      [&](const Vec3d& corner) { box.extendBy(corner); });
      }
    }
    for (const desc::Instance& instance : scene.instances) {
      add(objects[static_cast<std::size_t>(instance.object)], instance.to_world);
    }
  }

  /// `visit(corner)` with each corner in the world.
  template <typename Visit>
  void for_each_corner(const Visit& visit) const {
    for (const Part& part : parts_) visit_corners(part, visit);
  }

 private:
  struct Part {
    Imath::Box3d box;
    const Mat4* to_world;
  };

  template <typename Visit>
  static void visit_corners(const Part& part, const Visit& visit) {
    if (part.box.isEmpty()) return;
    for (const Vec3d& corner : corners_of(part.box)) {
      Vec3d placed;
      part.to_world->multVecMatrix(corner, placed);
      visit(placed);
    }
  }
  void add(const Imath::Box3d& box, const Mat4& to_world) {
    if (!box.isEmpty()) parts_.push_back({box, &to_world});
  }
  Imath::Box3d local_box(const desc::Shape& shape) {
    const desc::Node& node = shape.node;
    if (node.is("sphere") || node.is("disk") || node.is("cylinder")) return box_of_quadric(node);
    if (node.is("curves")) return box_of(*node.curves("curves"));
    const desc::MeshPointer mesh =
        shape.node.is("mesh") ? shape.node.mesh("mesh") : desc::MeshPointer();
    const auto [place, is_new] = boxes_.try_emplace(mesh.get());
    if (is_new && mesh) place->second = box_of(*mesh);
    return place->second;
  }

  std::map<const desc::Mesh*, Imath::Box3d> boxes_;
  std::vector<Part> parts_;
};

Mat4 frame(const Vec3d& x, const Vec3d& y, const Vec3d& z, const Vec3d& origin) {
  return {x.x, x.y, x.z, 0.0, y.x,      y.y,      y.z,      0.0,
          z.x, z.y, z.z, 0.0, origin.x, origin.y, origin.z, 1.0};
}

class Studio {
 public:
  Studio(desc::SceneDesc& scene, UpAxis up) : scene_(scene), up_(up) {
    box_ = bounds_of_shapes(scene);
    if (box_.isEmpty() || !std::isfinite(box_.size().length()))
      box_ = Imath::Box3d(Vec3d(-1.0), Vec3d(1.0));
    centre_ = box_.center();
    radius_ = 0.5 * box_.size().length();
    if (!(radius_ > 0.0)) radius_ = 1.0;  // radius for a single point
  }

  void add_camera() {
    const Vec3d toward = direction(kAzimuth, kElevation);
    const Vec3d forward = -toward;
    const Vec3d right = forward.cross(up_direction()).normalized();
    const Vec3d up = right.cross(forward);
    const PlacedBoxes boxes(scene_);
    const Extent across = extent_along(boxes, right, forward);
    const Extent upright = extent_along(boxes, up, forward);
    const double distance = std::max({across.distance, upright.distance, 0.1 * radius_});
    const Vec3d eye =
        centre_ + right * across.shift + up * upright.shift - forward * (kMargin * distance);
    desc::PerspectiveCamera camera;
    camera.fov = static_cast<float>(kFov);
    scene_.camera.node = camera;
    scene_.camera.to_world = frame(right, up, forward, eye);
    scene_.film.resolution = {960, 720};
  }

  void add_lights() {
    add_softbox(kKey);
    add_softbox(kRim);
    desc::Light& sky = scene_.lights.emplace_back();
    sky.node = desc::light_node("environment", {{"radiance", Vec3(kSky)}});
  }

  void add_table() {
    desc::Shape& table = scene_.shapes.emplace_back();
    table.name = "table";
    table.node = desc::shape_node("disk", {{"radius", static_cast<float>(kTableRadius * radius_)}});
    const Vec3d up = up_direction();
    const double below = (up_ == UpAxis::Y ? box_.min.y : box_.min.z) - kGapBelow * radius_;
    table.to_world = facing(up, centre_ + up * (below - centre_.dot(up)));
    scene_.materials.emplace_back().node =
        desc::material_node("diffuse", {{"reflectance", Vec3(kTable)}});
    table.material = static_cast<desc::MaterialId>(scene_.materials.size()) - 1;
  }

 private:
  /// From where all boxes just fit into the picture along one of its axes.
  struct Extent {
    double shift;     ///< displacement of the eye along the axis, from the centre
    double distance;  ///< from the centre to the eye
  };
  /// With x along the axis and z forward from the centre, and slope t of the edges of the picture,
  /// x − s <= t (z + d) and s − x <= t (z + d) hold for all corners from this d on.
  Extent extent_along(const PlacedBoxes& boxes, const Vec3d& axis, const Vec3d& forward) const {
    const double slope = std::tan(0.5 * kFov * kDegree);
    double most = -std::numeric_limits<double>::infinity();
    double least = most;
    const auto add = [&](const Vec3d& corner) {
      const double x = (corner - centre_).dot(axis);
      const double depth = slope * (corner - centre_).dot(forward);
      most = std::max(most, x - depth);
      least = std::max(least, -x - depth);
    };
    boxes.for_each_corner(add);
    if (!std::isfinite(most + least)) {
      most = least = 0.0;
      for (const Vec3d& corner : corners_of(box_)) add(corner);
    }
    return {0.5 * (most - least), 0.5 * (most + least) / slope};
  }

  Vec3d up_direction() const { return up_ == UpAxis::Y ? Vec3d(0, 1, 0) : Vec3d(0, 0, 1); }
  /// The front of a model looks along +z if y is up, along −y if z is.
  Vec3d direction(double azimuth, double elevation) const {
    const double right = std::cos(elevation) * std::sin(azimuth);
    const double front = std::cos(elevation) * std::cos(azimuth);
    const double above = std::sin(elevation);
    return up_ == UpAxis::Y ? Vec3d(right, above, front) : Vec3d(right, -front, above);
  }
  /// A place whose z is `normal`.
  static Mat4 facing(const Vec3d& normal, const Vec3d& origin) {
    const Vec3d helper = std::abs(normal.x) < 0.5 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
    const Vec3d x = helper.cross(normal).normalized();
    return frame(x, normal.cross(x), normal, origin);
  }

  void add_softbox(const Softbox& box) {
    const Vec3d toward = direction(box.azimuth, box.elevation);
    desc::Shape& disk = scene_.shapes.emplace_back();
    disk.name = "softbox";
    disk.node = desc::shape_node("disk", {{"radius", static_cast<float>(box.radius * radius_)}});
    disk.to_world = facing(-toward, centre_ + toward * (box.distance * radius_));
    disk.emission =
        desc::Emission{{}, desc::emission_node("area", {{"radiance", Vec3(box.radiance)}})};
    scene_.materials.emplace_back().node =
        desc::material_node("diffuse", {{"reflectance", Vec3(0.F)}});
    disk.material = static_cast<desc::MaterialId>(scene_.materials.size()) - 1;
  }

  desc::SceneDesc& scene_;
  UpAxis up_;
  Imath::Box3d box_;
  Vec3d centre_;
  double radius_;  ///< radius of the sphere around the box
};

bool surfaces_shine(const desc::SceneDesc& scene) {
  return std::any_of(scene.shapes.begin(), scene.shapes.end(),
                     [](const desc::Shape& shape) { return shape.emission.has_value(); });
}

}  // namespace

void add_studio(desc::SceneDesc& scene, const SceneParts& parts, UpAxis up) {
  Studio studio(scene, up);
  const bool is_bare = !parts.has_camera && !parts.has_lights;
  if (!parts.has_camera) studio.add_camera();
  if (is_bare || (!parts.has_lights && !(parts.has_lamps && surfaces_shine(scene))))
    studio.add_lights();
  if (is_bare) studio.add_table();
}

desc::MaterialId add_neutral_material(desc::SceneDesc& scene) {
  scene.materials.emplace_back().node = desc::material_node(
      "principled",
      {{"base_color", Vec3(0.6F)}, {"roughness", 0.4F}, {"blend", std::string("layered")}});
  return static_cast<desc::MaterialId>(scene.materials.size()) - 1;
}

Imath::Box3d bounds_of_shapes(const desc::SceneDesc& scene) {
  Imath::Box3d bounds;
  PlacedBoxes(scene).for_each_corner([&](const Vec3d& corner) { bounds.extendBy(corner); });
  return bounds;
}

}  // namespace ajar
