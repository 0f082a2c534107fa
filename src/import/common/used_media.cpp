#include "import/common/used_media.h"

#include <algorithm>

namespace ajar {

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

}  // namespace ajar
