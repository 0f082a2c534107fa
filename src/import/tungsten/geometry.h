#pragma once
#include <optional>
#include <vector>

#include "scene/desc/scene_desc.h"

namespace ajar::tungsten {

/// A shape of ours that a primitive is made of.
struct Part {
  desc::Node node;
  Mat4 to_world;
  bool reverse_orientation = false;
  /// A mirror has reversed the winding, and not the normals, which decide the outside of glass;
  /// emission and media go by the winding.
  bool has_turned_winding = false;
  int bsdf = 0;       ///< index into the bsdfs of the primitive
  double area = 0.0;  ///< in the world; that of curves, which cannot shine, is not known
};

/// The primitives that are described by their place alone. Flat ones, whose place may have a scale
/// of 0, are meshes in the world. Source: Tungsten, src/core/primitives.

/// The square from -1/2 to 1/2 in x and z. Its normal is y; u runs along x, v along z, as in
/// Tungsten from b39576b on; before, v ran against z.
Part quad(const Mat4& transform);
/// The cube from -1/2 to 1/2; a face across an axis has the next one as its u.
Part cube(const Mat4& transform);
/// Radius 1; the largest scale counts for all axes. The pole of its texture is z.
Part sphere(const Mat4& transform);
/// Radius 1 across y; the larger scale of x and z counts for both. v runs from the centre.
Part disk(const Mat4& transform);
/// Radius 1/2 around y, from -1/2 to 1/2, with lids if it is `capped`: Tungsten's textures run
/// across those, ours around.
std::vector<Part> cylinder(const Mat4& transform, bool capped);

/// A mesh file at its place. Its sides are those of its normals. Without normals they are those of
/// its triangles in the world, whatever mirrors them.
Part placed_mesh(desc::MeshPointer mesh, const Mat4& transform);

}  // namespace ajar::tungsten
