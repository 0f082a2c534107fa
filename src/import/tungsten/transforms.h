#pragma once
#include "import/tungsten/object_reader.h"

/// Places as Tungsten writes them, as row-vector matrices (p' = p * M).
namespace ajar::tungsten {

/// From {"position", "scale", "rotation", "look_at", "up", "x_axis", "y_axis", "z_axis"}, or from
/// 16 numbers of a matrix for column vectors, row by row. Raises SceneError if it is neither.
/// Source: Tungsten, src/core/io/JsonPtr.cpp.
Mat4 transform_of(const Context& context, const LocatedJson& json);
/// From the members of an object itself, which may have others.
Mat4 transform_from_members(const ObjectReader& object);
/// The member "transform" of an object; the identity without one.
Mat4 transform_of(const Context& context, const ObjectReader& object);

/// Images of the unit vectors, and of the origin.
Vec3d axis_of(const Mat4& transform, int axis);
Vec3d origin_of(const Mat4& transform);
Mat4 from_axes(const Vec3d& x, const Vec3d& y, const Vec3d& z, const Vec3d& origin);

/// The transform without its scale and, for `with_origin` false, without its translation. An axis
/// of length 0 becomes the one that completes the others.
Mat4 without_scale(const Mat4& transform, bool with_origin);
/// Lengths of the images of x, y and z.
Vec3d scale_of(const Mat4& transform);

/// True if it has an inverse, as the renderer needs it.
bool is_invertible(const Mat4& transform);

}  // namespace ajar::tungsten
