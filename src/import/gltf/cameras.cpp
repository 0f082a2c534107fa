#include "import/gltf/cameras.h"

#include <algorithm>
#include <cmath>

#include "core/printable_text.h"

namespace ajar::gltf {
namespace {

constexpr WarningKind kMoreCameras{Effect::None, "cameras are not used: the first is"};
constexpr double kUsualAspect = 16.0 / 9.0;

/// A number above 0.
double positive(const Element& element, const char* name) {
  const Element member = element.at(name);
  const double number = member.number();
  if (!(number > 0.0)) member.fail("this must be above 0");
  return number;
}

/// A film of this shape with the usual number of pixels along the shorter side.
Vec2i resolution_of(double aspect) {
  constexpr double kShorter = 720.0;
  constexpr double kMostAspect = 100.0;
  aspect = std::clamp(aspect, 1.0 / kMostAspect, kMostAspect);
  const double width = aspect >= 1.0 ? kShorter * aspect : kShorter;
  const double height = aspect >= 1.0 ? kShorter : kShorter / aspect;
  return {static_cast<int>(std::lround(width)), static_cast<int>(std::lround(height))};
}

/// A `SceneDesc` has the angle of the shorter side, glTF that of the vertical one.
void set_perspective(const Element& perspective, desc::SceneDesc& scene) {
  const double yfov = positive(perspective, "yfov");
  if (!(yfov < M_PI)) perspective.at("yfov").fail("this angle must be below pi");
  const double aspect =
      perspective.has("aspectRatio") ? positive(perspective, "aspectRatio") : kUsualAspect;
  const double half = std::tan(yfov / 2.0) * std::min(aspect, 1.0);
  desc::PerspectiveCamera camera;
  camera.fov = static_cast<float>(2.0 * std::atan(half) * 180.0 / M_PI);
  scene.camera.node = camera;
  scene.film.resolution = resolution_of(aspect);
}

void set_orthographic(const Element& orthographic, desc::SceneDesc& scene) {
  const double x = positive(orthographic, "xmag");
  const double y = positive(orthographic, "ymag");
  desc::OrthographicCamera camera;
  camera.window = desc::ScreenWindow{static_cast<float>(-x), static_cast<float>(x),
                                     static_cast<float>(-y), static_cast<float>(y)};
  scene.camera.node = camera;
  scene.film.resolution = resolution_of(x / y);
}

}  // namespace

bool set_camera(Context& context, const std::vector<PlacedNode>& nodes) {
  const std::vector<Element> cameras = context.document.root.items("cameras");
  bool found = false;
  for (const PlacedNode& placed : nodes) {
    const std::optional<std::size_t> i = placed.node.find_index("camera", cameras.size());
    if (!i) continue;
    const Element& camera = cameras[*i];
    if (found) {
      context.warnings.add(kMoreCameras, camera.where(),
                           "this camera is not used: the scene has one before it");
      continue;
    }
    found = true;
    context.scene.camera.where = camera.where();
    context.scene.camera.to_world = turned_around(without_scale(placed.to_world));
    const Element type = camera.at("type");
    if (const std::string name = type.text(); name == "perspective") {
      set_perspective(camera.at("perspective"), context.scene);
    } else if (name == "orthographic") {
      set_orthographic(camera.at("orthographic"), context.scene);
    } else {
      type.fail(unknown_name_message("type of camera", printable_line(name),
                                     std::vector<std::string>{"orthographic", "perspective"}));
    }
  }
  return found;
}

}  // namespace ajar::gltf
