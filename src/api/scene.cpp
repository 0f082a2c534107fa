#include "ajar/scene.h"

#include <utility>

#include "api/contents.h"
#include "session/scenes/scene_file.h"

namespace ajar::v0 {

Scene::Scene(std::shared_ptr<const Content> content) : content_(std::move(content)) {}

Scene Scene::load(const std::string& name) {
  return with_public_errors([&] {
    const auto content = std::make_shared<Content>();
    content->name = name;
    content->loaded = std::make_shared<LoadedScene>(load_scene(name, content->warnings));
    return Scene(content);
  });
}

const std::string& Scene::name() const { return content_->name; }
int Scene::width() const { return content_->loaded->description().film.resolution.x; }
int Scene::height() const { return content_->loaded->description().film.resolution.y; }
std::vector<std::string> Scene::warnings() const { return content_->warnings.messages(); }

}  // namespace ajar::v0
