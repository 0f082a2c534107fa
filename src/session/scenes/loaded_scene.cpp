#include "session/scenes/loaded_scene.h"

namespace ajar {

BuiltScene::BuiltScene(desc::SceneDesc&& description, Vec2i resolution, std::string other_filter)
    : filter(std::move(other_filter)),
      scene(std::move(description), BuildOptions{resolution}, warnings) {}

std::shared_ptr<const BuiltScene> LoadedScene::built(Vec2i resolution, const std::string& filter) {
  const std::lock_guard lock(mutex_);
  if (last_ && (last_->scene.film().resolution != resolution || last_->filter != filter)) {
    last_.reset();
  }
  return last_;
}

void LoadedScene::keep(std::shared_ptr<const BuiltScene> built) {
  const std::lock_guard lock(mutex_);
  last_ = std::move(built);
}

}  // namespace ajar
