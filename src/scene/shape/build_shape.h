#pragma once
#include <cstdint>
#include <memory>
#include <variant>

#include "core/warnings.h"
#include "scene/desc/scene_desc.h"
#include "scene/shape/curve_shape.h"
#include "scene/shape/quadric.h"
#include "scene/shape/triangle_mesh.h"

namespace ajar {

/// Geometry of a shape, of one of the kinds that `Geometry` can hand to Embree; nothing if it is
/// empty.
using BuiltShape = std::variant<std::monostate, Quadric, std::unique_ptr<const TriangleMesh>,
                                std::unique_ptr<const CurveShape>>;

/// The shape in its final place. Takes meshes and curves out of the description, so that they are
/// in memory once. Shapes without area are a warning. Raises SceneError for shapes of no model and
/// for those that cannot be used.
BuiltShape build_shape(desc::Shape& shape, const Placement& placement, Warnings& warnings);

/// Memory that building the shape takes beside its description, bytes, as estimates go. Raises
/// SceneError if this shape alone needs more than there is.
std::uint64_t shape_memory(const desc::Shape& shape);

}  // namespace ajar
