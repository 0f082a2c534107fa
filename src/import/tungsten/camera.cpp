#include "import/tungsten/camera.h"

#include <algorithm>
#include <cmath>

#include "import/common/resolution.h"
#include "import/tungsten/textures.h"
#include "import/tungsten/transforms.h"

namespace ajar::tungsten {
namespace {

constexpr WarningKind kCubemap{
    Effect::Light,
    "cube map cameras are not supported: pictures of longitude by latitude stand in"};
constexpr WarningKind kUnknownCamera{Effect::Light, "cameras are unknown: pinholes stand in"};
constexpr WarningKind kUnknownFilter{Effect::Slight, "filters are unknown: tents stand in"};
constexpr WarningKind kDirac{Effect::Slight,
                             "filters of one point are not supported: boxes stand in"};
constexpr WarningKind kAperture{Effect::Slight,
                                "lenses have a shape of their own, which is ignored: round"};
constexpr WarningKind kUnknownFocus{Effect::Surface,
                                    "cameras focus on primitives that are unknown"};
constexpr WarningKind kTonemap{Effect::None, "tone maps of the scene are not used"};

const std::vector<std::string> kCameraTypes = {"pinhole", "thinlens", "equirectangular", "cubemap"};
const std::vector<std::string> kFilters = {
    "dirac", "box", "tent", "gaussian", "mitchell_netravali", "catmull_rom", "lanczos"};

Vec2i resolution_of(const LocatedJson& json) {
  Vec2i resolution;
  if (json.is(LocatedJson::Kind::Number)) {
    resolution = Vec2i(json.as<int>());
  } else if (json.is(LocatedJson::Kind::Array) && json.size() == 2) {
    resolution = Vec2i(json[0].as<int>(), json[1].as<int>());
  } else {
    throw SceneError(json.where(), "the resolution must be a number or an array of two");
  }
  for (const int n : {resolution.x, resolution.y}) {
    if (n < 1 || n > kLargestResolution) {
      throw SceneError(json.where(), "the resolution must be 1 to " +
                                         std::to_string(kLargestResolution) + ", not " +
                                         std::to_string(n));
    }
  }
  return resolution;
}

/// Filters and their widths: Tungsten, src/core/cameras/ReconstructionFilter.
desc::Filter filter_of(const Context& context, const LocatedJson& json) {
  const std::string& name = json.text();
  desc::Filter filter;
  filter.where = json.where();
  filter.radius = Vec2(2.F, 2.F);
  if (name == "gaussian") {
    filter.node = desc::GaussianFilter{2.F};
  } else if (name == "mitchell_netravali") {
    filter.node = desc::MitchellFilter{1.F / 3.F, 1.F / 3.F};
  } else if (name == "catmull_rom") {
    filter.node = desc::MitchellFilter{0.F, 0.5F};
  } else if (name == "lanczos") {
    filter.node = desc::SincFilter{2.F};
  } else if (name == "box" || name == "dirac") {
    filter.radius = Vec2(0.5F, 0.5F);
    filter.node = desc::BoxFilter{};
    if (name == "dirac") {
      context.warnings.add(kDirac, json.where(),
                           "the filter \"dirac\" is not supported: \"box\" stands in");
    }
  } else {
    filter.radius = Vec2(1.F, 1.F);
    filter.node = desc::TriangleFilter{};
    if (name != "tent") {
      context.warnings.add(
          kUnknownFilter, json.where(),
          unknown_name_message("filter", printable(name), kFilters) + ". \"tent\" stands in",
          printable(name));
    }
  }
  return filter;
}

/// Tungsten's angle is that of the width of the picture, ours that of its shorter side.
float shorter_fov(const ObjectReader& object, const Vec2i& resolution) {
  const double degrees = static_cast<double>(object.number("fov").value_or(60.F));
  if (!(degrees > 0.0 && degrees < 180.0)) {
    throw SceneError(object.where(), "\"fov\" must be between 0 and 180 degrees");
  }
  if (resolution.x <= resolution.y) return static_cast<float>(degrees);
  constexpr double kHalfDegree = 3.14159265358979323846 / 360.0;
  const double half = std::tan(degrees * kHalfDegree) * resolution.y / resolution.x;
  return static_cast<float>(std::atan(half) / kHalfDegree);
}

float focus_of(const Context& context, const ObjectReader& object, const Vec3d& eye,
               const PrimitivePlaces& places) {
  const float distance = object.number("focus_distance").value_or(1.F);
  const std::optional<std::string> pivot = object.text("focus_pivot");
  if (!pivot || pivot->empty()) return distance;
  const auto found = places.find(*pivot);
  if (found == places.end()) {
    context.warnings.add(kUnknownFocus, object.where(),
                         "there is no primitive \"" + printable(*pivot) +
                             "\" to focus on: \"focus_distance\" counts");
    return distance;
  }
  return static_cast<float>((origin_of(found->second) - eye).length());
}

desc::PerspectiveCamera thin_lens(const Context& context, const ObjectReader& object,
                                  const Vec3d& eye, const PrimitivePlaces& places) {
  desc::PerspectiveCamera node;
  node.lens_radius = object.number("aperture_size").value_or(0.001F);
  node.focal_distance = focus_of(context, object, eye, places);
  if (node.lens_radius < 0.F) throw SceneError(object.where(), "\"aperture_size\" is negative");
  if (!(node.focal_distance > 0.F)) {
    throw SceneError(object.where(), "the distance of focus must be positive");
  }
  const auto aperture = object.find("aperture");
  const bool is_round = aperture && type_of(*aperture) == "disk";
  if (aperture) check_texture(context, *aperture);
  if ((aperture && !is_round) || object.number("cateye").value_or(0.F) > 0.F) {
    context.warnings.add(kAperture, object.where(),
                         "only round lenses are supported, without \"cateye\": one stands in");
  }
  return node;
}

}  // namespace

void read_camera(Context& context, const LocatedJson& json, MediumTable& media,
                 const PrimitivePlaces& places) {
  const ObjectReader object(context, json, "a camera");
  desc::Camera& camera = context.scene.camera;
  desc::Film& film = context.scene.film;
  camera.where = film.where = json.where();

  // Older files have the place in the camera itself.
  const Mat4 placed =
      !object.has("transform") ? transform_from_members(object) : transform_of(context, object);
  const Mat4 frame = without_scale(placed, true);
  if (!is_invertible(frame)) {
    throw SceneError(json.where(), "the transform of the camera cannot be inverted");
  }
  const auto resolution = object.find("resolution");
  film.resolution = resolution ? resolution_of(*resolution) : Vec2i(1000, 563);
  const auto filter = object.find("reconstruction_filter");
  film.filter.radius = Vec2(1.F, 1.F);
  film.filter.node = desc::TriangleFilter{};
  if (filter) film.filter = filter_of(context, *filter);
  film.filename = object.text("file").value_or(film.filename);

  const std::string type = object.text("type").value_or("pinhole");
  if (type == "equirectangular" || type == "cubemap") {
    if (type == "cubemap") {
      context.warnings.add(kCubemap, json.where(),
                           "the camera \"cubemap\" is not supported: a picture of longitude by "
                           "latitude stands in");
      object.accept({"mode"});
    }
    camera.node = desc::EnvironmentCamera{};
    // Its picture begins half a turn from where ours does.
    camera.to_world =
        from_axes(axis_of(frame, 0), axis_of(frame, 1), -axis_of(frame, 2), origin_of(frame));
    object.accept({"fov"});
  } else {
    if (std::find(kCameraTypes.begin(), kCameraTypes.end(), type) == kCameraTypes.end()) {
      context.warnings.add(
          kUnknownCamera, json.where(),
          unknown_name_message("camera", printable(type), kCameraTypes) + ". A pinhole stands in",
          printable(type));
    }
    desc::PerspectiveCamera node;
    if (type == "thinlens") node = thin_lens(context, object, origin_of(frame), places);
    node.fov = shorter_fov(object, film.resolution);
    camera.node = node;
    // Right-handed, looking along +z with y up: to the right is −x.
    camera.to_world =
        from_axes(-axis_of(frame, 0), axis_of(frame, 1), axis_of(frame, 2), origin_of(frame));
  }
  if (const auto medium = object.find("medium")) camera.medium = media.resolve(*medium);
  if (object.text("tonemap").value_or("linear") != "linear") {
    context.warnings.add(kTonemap, json.where(),
                         "\"tonemap\" is not used: pictures have the tone map of their format");
  }
  object.accept({"spp", "name"});
  object.report_unknown();
}

}  // namespace ajar::tungsten
