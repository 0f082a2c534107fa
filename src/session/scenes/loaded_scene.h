#pragma once
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "core/vector.h"
#include "core/warnings.h"
#include "scene/desc/scene_desc.h"
#include "scene/scene.h"

namespace ajar {

/// A scene as a render built it: for pictures of a size, through a filter.
struct BuiltScene {
  /// `filter`: what the description's was replaced by, see `parse_filter`; empty: nothing.
  BuiltScene(desc::SceneDesc&& description, Vec2i resolution, std::string filter);

  std::string filter;
  Warnings warnings;  ///< warnings on it
  Scene scene;
};

/// A scene that was read once, for any number of renders, one after the other or at once. It keeps
/// what was built last, for those of other methods, parameters and seeds: only the size of the
/// picture and its filter need another.
class LoadedScene {
 public:
  explicit LoadedScene(desc::SceneDesc description) : description_(std::move(description)) {}

  const desc::SceneDesc& description() const { return description_; }
  /// The built scene; null if it must be built. A scene that was built for another picture is
  /// released, so that there are never two.
  std::shared_ptr<const BuiltScene> built(Vec2i resolution, const std::string& filter);
  /// Nobody waits while a scene is built: two renders that begin at once both build it.
  void keep(std::shared_ptr<const BuiltScene> built);

 private:
  const desc::SceneDesc description_;
  std::mutex mutex_;
  std::shared_ptr<const BuiltScene> last_;
};

}  // namespace ajar
