#include "import/mitsuba/sensor.h"

#include <cmath>

#include "core/printable_text.h"
#include "import/common/degree.h"
#include "import/common/studio.h"
#include "import/common/transforms.h"
#include "import/mitsuba/plugin_types.h"
#include "import/mitsuba/view.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kUnknownSensor{Effect::Light,
                                     "sensors are not supported: perspective ones stand in"};
constexpr WarningKind kClipped{Effect::Slight, "cameras have clip planes: not supported"};
constexpr WarningKind kResponse{Effect::Surface,
                                "sensors have a response to wavelengths, which is not supported"};
/// Tangent of half the field of view along the width of the film.
double half_width(Arguments& arguments, double aspect) {
  GivenView view = read_view(arguments);
  const double tangent = std::tan(0.5 * view.fov * kDegree);
  if (view.axis == "shorter") view.axis = aspect > 1.0 ? "y" : "x";
  if (view.axis == "longer") view.axis = aspect > 1.0 ? "x" : "y";
  if (view.axis == "y") return tangent * aspect;
  if (view.axis == "diagonal") return tangent / std::sqrt(1.0 + 1.0 / (aspect * aspect));
  return tangent;
}

desc::PerspectiveCamera perspective(Arguments& arguments, double aspect) {
  desc::PerspectiveCamera camera;
  const double width = half_width(arguments, aspect);
  const double shorter = aspect > 1.0 ? width / aspect : width;
  camera.fov = static_cast<float>(2.0 * std::atan(shorter) / kDegree);
  const float x = arguments.number("principal_point_offset_x", 0.F);
  const float y = arguments.number("principal_point_offset_y", 0.F);
  if (x != 0.F || y != 0.F) {
    // Shifts of the picture to the left and up, as shares of the film. Source: Mitsuba 3,
    // perspective.cpp, which adds them to the place on the film.
    const auto wide = static_cast<float>(std::max(aspect, 1.0));
    const auto high = static_cast<float>(std::max(1.0 / aspect, 1.0));
    camera.window = desc::ScreenWindow{-wide * (1.F - 2.F * x), wide * (1.F + 2.F * x),
                                       -high * (1.F + 2.F * y), high * (1.F - 2.F * y)};
  }
  return camera;
}

constexpr float kNear = 1e-2F;
constexpr float kFar = 1e4F;

template <typename Camera>
void set_lens(Arguments& arguments, Camera& camera) {
  camera.lens_radius = arguments.number("aperture_radius", 0.F);
  camera.focal_distance = arguments.number("focus_distance", arguments.number("far_clip", kFar));
  if (camera.lens_radius < 0.F)
    throw SceneError(arguments.where(), "\"aperture_radius\" is negative");
  if (!(camera.focal_distance > 0.F)) {
    throw SceneError(arguments.where(), "\"focus_distance\" must be positive");
  }
}

desc::OrthographicCamera orthographic(double aspect) {
  // Mitsuba shows x from -1 to 1, for any shape of the film.
  desc::OrthographicCamera camera;
  const auto height = static_cast<float>(1.0 / aspect);
  camera.window = desc::ScreenWindow{-1.F, 1.F, -height, height};
  return camera;
}

/// From the space of our camera to that of Mitsuba's.
Mat4 to_mitsuba_camera(const std::string& type) {
  // Both look along +z with +y up, but Mitsuba's +x is to the left.
  if (type != "spherical") return scaling({-1.0, 1.0, 1.0});
  // Our panorama begins at +x and goes on toward +z, Mitsuba's begins at -z and goes on toward +x.
  return {0.0, 0.0, -1.0, 0.0,  //
          0.0, 1.0, 0.0,  0.0,  //
          1.0, 0.0, 0.0,  0.0,  //
          0.0, 0.0, 0.0,  1.0};
}

}  // namespace

void look_at_everything(Context& context) {
  constexpr double kFov = 45.0;  // along the width
  desc::SceneDesc& scene = context.scene;
  scene.film = default_film(context.document.end);
  const Vec2i size = scene.film.resolution;
  const double half = std::tan(0.5 * kFov * kDegree);
  desc::PerspectiveCamera camera;
  camera.fov = static_cast<float>(2.0 * std::atan(half * size.y / size.x) / kDegree);
  scene.camera.node = camera;
  scene.camera.where = context.document.end;
  const Imath::Box3d box = bounds_of_shapes(scene);
  Vec3d eye(0.0);
  if (!box.isEmpty()) {
    const Vec3d extent = box.size();
    const double distance = std::max({extent.x, extent.y, extent.z}) / (2.0 * half);
    eye = Vec3d(box.center().x, box.center().y, box.min.z - distance);
  }
  scene.camera.to_world = to_mitsuba_camera("perspective") * translation(eye);
}

void read_sensor(Context& context, MediumTable& media, const Element& element) {
  Arguments arguments(context, element);
  context.scene.film = default_film(element.where);
  if (const Element* film = arguments.only_child("film")) read_film(context, *film);
  if (const Element* sampler = arguments.only_child("sampler")) read_sampler(context, *sampler);
  const Vec2i size = context.scene.film.resolution;
  const double aspect = static_cast<double>(size.x) / size.y;

  desc::Camera camera;
  camera.where = element.where;
  if (element.type == "orthographic" || element.type == "telecentric") {
    desc::OrthographicCamera node = orthographic(aspect);
    if (element.type == "telecentric") set_lens(arguments, node);
    camera.node = node;
  } else if (element.type == "spherical") {
    camera.node = desc::EnvironmentCamera{};
  } else {
    if (!is_known(element)) {
      context.warnings.add(kUnknownSensor, element.where,
                           unknown_type_message(element) + ". A perspective one stands in",
                           printable(element.type));
      arguments.accept_all();
    }
    desc::PerspectiveCamera node = perspective(arguments, aspect);
    if (element.type == "thinlens") set_lens(arguments, node);
    camera.node = node;
  }
  const Mat4 to_world =
      to_mitsuba_camera(element.type) * arguments.transform("to_world").value_or(Mat4());
  const std::optional<Mat4> from_world = inverse(to_world);
  if (!from_world) {
    throw SceneError(element.where, "the transform of the camera cannot be inverted");
  }
  // Rounded, so that other formats, which say the inverse, can say the same.
  camera.to_world = rounded_inverse(*from_world).value_or(to_world);
  if (const Element* medium = arguments.only_child("medium")) camera.medium = media.make(*medium);
  // Mitsuba's defaults clip nothing of usual scenes.
  const float near_clip = arguments.number("near_clip", kNear);
  const float far_clip = arguments.number("far_clip", kFar);
  const auto warn_if_seen = [&](desc::WarningIfSeen::If condition, float depth,
                                const std::string& message) {
    context.scene.warnings_if_seen.push_back(
        {condition, desc::kNone, depth, {kClipped, element.where, message}});
  };
  const bool is_old = context.document.major_version == 0;
  if (near_clip > kNear) {
    warn_if_seen(desc::WarningIfSeen::If::Nearer, near_clip,
                 std::string(is_old ? "\"nearClip\"" : "\"near_clip\"") +
                     " is not supported: what is nearer is seen, too");
  }
  if (far_clip < kFar) {
    warn_if_seen(desc::WarningIfSeen::If::Farther, far_clip,
                 std::string(is_old ? "\"farClip\"" : "\"far_clip\"") +
                     " is not supported: what is farther is seen, too");
  }
  if (arguments.has("srf")) {
    arguments.accept({"srf"});
    context.warnings.add(kResponse, element.where,
                         "\"srf\" is not supported: the picture has the colours that eyes see");
  }
  arguments.accept({"shutter_open", "shutter_close", "focus_distance"});
  context.scene.camera = camera;
}

}  // namespace ajar::mitsuba
