#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "ajar/namespace.h"

namespace ajar::AJAR_INTERFACE {
/// Numbers of the caller, row by row; copied while a scene is made of them.
struct Array {
  enum class Type { Float32, UInt32, UInt8 };
  const void* data = nullptr;
  Type type = Type::Float32;
  std::vector<std::size_t> shape;  ///< 1 to 3 dimensions
};

/// A scene that was read or described, to be rendered any number of times. Copies share it; it
/// never changes. It keeps the acceleration structure of the last render: the next begins at once,
/// whatever its method, parameters and seed, if only its resolution and filter are the same.
class Scene {
 public:
  /// A file in any format that `ajar render` takes, or `builtin:NAME`. Raises Error.
  static Scene load(const std::string& name);
  /// A scene that `changes` make of an empty one: JSON that refers to `arrays`
  /// (docs/c-interface.md). Raises Error.
  static Scene describe(const std::string& changes, std::span<const Array> arrays = {});
  /// Another scene, which is this one with changes. Raises Error.
  Scene changed(const std::string& changes, std::span<const Array> arrays = {}) const;

  /// Name of the file, of the built-in scene or of the description.
  const std::string& name() const;
  // Size of the scene's picture, pixels.
  int width() const;
  int height() const;
  /// Warnings on its files, one sentence each, with its place: the largest effects first.
  std::vector<std::string> warnings() const;
  /// Textures, materials, lights and shapes with their parameters, which changes can edit: JSON.
  std::string parts() const;

  struct Content;
  // For the library itself.
  explicit Scene(std::shared_ptr<const Content> content);
  const Content& content() const { return *content_; }

 private:
  std::shared_ptr<const Content> content_;
};
}  // namespace ajar::AJAR_INTERFACE
