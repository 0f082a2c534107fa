#pragma once
#include <span>
#include <string>

#include "scene/desc/scene_desc.h"

namespace ajar {

/// Gives `shape` a neutral material with `colors` of the vertices of `mesh` (linear, one per
/// vertex), and the mesh that leads to them. `name` names their image in the scene.
void paint_shape(desc::Shape& shape, const desc::Mesh& mesh, std::span<const Vec3> colors,
                 const std::string& name, desc::SceneDesc& scene);

}  // namespace ajar
