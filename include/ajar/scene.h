#pragma once
#include <memory>
#include <string>
#include <vector>

#include "ajar/namespace.h"

namespace ajar::AJAR_INTERFACE {
/// A scene that was read, to be rendered any number of times. Copies share it; it never changes. It
/// keeps the acceleration structure of the last render: the next begins at once, whatever its
/// method, parameters and seed, if only its resolution and filter are the same.
class Scene {
 public:
  /// A file in any format that `ajar render` takes, or `builtin:NAME`. Raises Error.
  static Scene load(const std::string& name);

  /// As it was loaded.
  const std::string& name() const;
  // Size of the scene's picture, pixels.
  int width() const;
  int height() const;
  /// Warnings on its files, one sentence each, with its place: the largest effects first.
  std::vector<std::string> warnings() const;

  struct Content;
  // For the library itself.
  explicit Scene(std::shared_ptr<const Content> content);
  const Content& content() const { return *content_; }

 private:
  std::shared_ptr<const Content> content_;
};
}  // namespace ajar::AJAR_INTERFACE
