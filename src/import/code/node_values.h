#pragma once
#include <functional>
#include <nlohmann/json_fwd.hpp>

#include "import/code/array_reader.h"
#include "scene/desc/models.h"

/// Values of nodes from JSON and back.
namespace ajar::code {

/// References of nodes: by number, among those of the description, or by name, among those of the
/// scene. Raise SceneError for unknown ones.
struct References {
  std::function<desc::TextureId(const LocatedJson& which)> texture;
  std::function<desc::MaterialId(const LocatedJson& which)> material;
};

/// A node: {"model": …, "parameters": {…}}. Members beside these are for the caller. Raises
/// SceneError for unknown names (with the nearest) and for values that a parameter cannot have.
desc::Node read_node(desc::ModelKind kind, const LocatedJson& json, const ArrayReader& arrays,
                     const References& references);
/// Changes the parameters that are given.
void set_parameters(desc::ModelKind kind, desc::Node& node, const LocatedJson& json,
                    const ArrayReader& arrays, const References& references);

/// 16 numbers, row by row, of a matrix that columns are multiplied with: p' = M p.
Mat4 read_transform(const LocatedJson& json);
/// The other way round. Geometry is left out.
nlohmann::ordered_json node_json(const desc::Node& node);

/// "material", …, as in messages.
const char* name_of(desc::ModelKind kind);

}  // namespace ajar::code
