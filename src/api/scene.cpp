#include "ajar/scene.h"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include "api/contents.h"
#include "import/code/scene_changes.h"
#include "session/scenes/scene_file.h"

namespace ajar::v0 {

namespace {

/// `number`: which of the caller's, for messages.
NumberArray number_array(const Array& from, std::size_t number) {
  const auto check = [&](bool holds, const char* otherwise) {
    if (!holds) throw UsageError(fmt::format("arrays[{}] {}", number, otherwise));
  };
  using Type = NumberArray::Type;
  check(from.type <= Array::Type::UInt8, "has none of the types that there are");
  check(!from.shape.empty() && from.shape.size() <= 3, "has not 1 to 3 dimensions");
  // More than there are addresses for.
  std::size_t left = std::numeric_limits<std::ptrdiff_t>::max() / sizeof(float);
  for (const std::size_t length : from.shape) {
    if (length > 0) left /= length;
  }
  check(left > 0, "has a shape of more numbers than there can be");
  NumberArray array{static_cast<Type>(from.type), from.shape, from.data};
  check(from.data != nullptr || array.size() == 0, "has no numbers");
  return array;
}

/// `base`: null for an empty scene.
Scene with_changes(const Scene::Content* base, const std::string& changes,
                   std::span<const Array> arrays) {
  std::vector<NumberArray> numbers;
  for (const Array& array : arrays) numbers.push_back(number_array(array, numbers.size()));
  const auto content = std::make_shared<Scene::Content>();
  desc::SceneDesc description;
  if (base != nullptr) {
    description = base->loaded->description();
    content->name = base->name;
    content->warnings.add_all(base->warnings);
  }
  description = changed_scene(std::move(description), changes, numbers, content->warnings);
  if (base == nullptr) content->name = description.source.empty() ? "scene" : description.source;
  content->loaded = std::make_shared<LoadedScene>(std::move(description));
  return Scene(content);
}

}  // namespace

Scene::Scene(std::shared_ptr<const Content> content) : content_(std::move(content)) {}

Scene Scene::load(const std::string& name) {
  return with_public_errors([&] {
    const auto content = std::make_shared<Content>();
    content->name = name;
    content->loaded = std::make_shared<LoadedScene>(load_scene(name, content->warnings));
    return Scene(content);
  });
}

Scene Scene::describe(const std::string& changes, std::span<const Array> arrays) {
  return with_public_errors([&] { return with_changes(nullptr, changes, arrays); });
}

Scene Scene::changed(const std::string& changes, std::span<const Array> arrays) const {
  return with_public_errors([&] { return with_changes(content_.get(), changes, arrays); });
}

const std::string& Scene::name() const { return content_->name; }
int Scene::width() const { return content_->loaded->description().film.resolution.x; }
int Scene::height() const { return content_->loaded->description().film.resolution.y; }
std::vector<std::string> Scene::warnings() const { return content_->warnings.messages(); }
std::string Scene::parts() const { return editable_parts(content_->loaded->description()); }

}  // namespace ajar::v0
