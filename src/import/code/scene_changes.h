#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/warnings.h"
#include "scene/desc/models.h"
#include "scene/desc/scene_desc.h"

/// Scenes that programs describe, and changes of scenes. Names and values are JSON
/// (docs/c-interface.md), bulk data arrays that it refers to. Models, parameters, defaults and
/// ranges are those of `scene/desc/models.h`.
namespace ajar {

/// Numbers of a program, row by row; `shape` says how many there are along each dimension.
struct NumberArray {
  enum class Type { Float32, UInt32, UInt8 };
  Type type = Type::Float32;
  std::vector<std::size_t> shape;
  const void* data = nullptr;

  std::size_t size() const;
};

/// `scene` with additions, settings and edits of `changes`. Places in messages are those that the
/// changes give ("where": a file and a line). Raises SceneError.
desc::SceneDesc changed_scene(desc::SceneDesc scene, std::string_view changes,
                              std::span<const NumberArray> arrays, Warnings& warnings);

/// Raises the SceneError that `changed_scene` would raise for one node by itself: `{"model": …,
/// "parameters": …}`.
void check_node(desc::ModelKind kind, std::string_view node);

/// Parts that `changed_scene` can edit: names, models, and parameters, as JSON.
std::string editable_parts(const desc::SceneDesc& scene);

}  // namespace ajar
