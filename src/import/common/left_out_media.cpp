#include "import/common/left_out_media.h"

#include <algorithm>

#include "core/printable_text.h"

namespace ajar {
namespace {

constexpr WarningKind kLeftOut{Effect::Light,
                               "integrators leave out media, which the scene has: they are shown"};

bool uses_media(const desc::SceneDesc& scene) {
  const auto has_some = [](const std::vector<desc::Shape>& shapes) {
    return std::any_of(shapes.begin(), shapes.end(), [](const desc::Shape& shape) {
      return shape.inside != desc::kNone || shape.outside != desc::kNone;
    });
  };
  return scene.camera.medium != desc::kNone || has_some(scene.shapes) ||
         std::any_of(scene.objects.begin(), scene.objects.end(),
                     [&](const desc::Object& object) { return has_some(object.shapes); }) ||
         std::any_of(scene.lights.begin(), scene.lights.end(),
                     [](const desc::Light& light) { return light.medium != desc::kNone; });
}

}  // namespace

void warn_of_left_out_media(const desc::SceneDesc& scene, const SourceLocation& where,
                            const std::string& integrator, const std::string& renderer,
                            Warnings& warnings) {
  if (!uses_media(scene)) return;
  warnings.add(kLeftOut, where,
               "\"" + printable(integrator) + "\" of " + renderer +
                   " leaves out media, of which this scene has some: here they are shown");
}

}  // namespace ajar
