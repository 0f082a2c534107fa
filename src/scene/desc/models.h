#pragma once
#include <string_view>
#include <vector>

#include "scene/desc/node.h"

/// All models that scenes can be described with. They are defined beside their implementations
/// (`scene/material/` …); descriptions of scenes need no more than this.
namespace ajar::desc {

enum class ModelKind { Material, Texture, Light, Emission, Shape };
/// For loops over all of them.
inline constexpr ModelKind kModelKinds[] = {ModelKind::Material, ModelKind::Texture,
                                            ModelKind::Light, ModelKind::Emission,
                                            ModelKind::Shape};

/// In the order of their names.
const std::vector<const Model*>& models(ModelKind kind);
/// The model of this name, or null.
const Model* find_model(ModelKind kind, std::string_view name);
/// A node of the model of this name, as `Node`'s constructor makes it. Raises std::logic_error if
/// there is none.
Node make_node(ModelKind kind, std::string_view name, Node::Given given = {});
inline Node material_node(std::string_view name, Node::Given given = {}) {
  return make_node(ModelKind::Material, name, given);
}
inline Node texture_node(std::string_view name, Node::Given given = {}) {
  return make_node(ModelKind::Texture, name, given);
}
inline Node light_node(std::string_view name, Node::Given given = {}) {
  return make_node(ModelKind::Light, name, given);
}
inline Node emission_node(std::string_view name, Node::Given given = {}) {
  return make_node(ModelKind::Emission, name, given);
}
inline Node shape_node(std::string_view name, Node::Given given = {}) {
  return make_node(ModelKind::Shape, name, given);
}
inline Node mesh_node(MeshPointer mesh) {
  return shape_node("mesh", {{"mesh", Value(std::move(mesh))}});
}

}  // namespace ajar::desc
