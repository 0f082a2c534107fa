#pragma once
#include "scene/desc/scene_desc.h"

namespace ajar {

/// Gives a valid mesh (`validate_mesh`) normals at its vertices: means of those of the triangles
/// there, weighted by their angles. Vertices without triangles get the z axis. Source: Thürmer and
/// Wüthrich 1998, Computing vertex normals from polygonal facets.
void make_smooth_normals(desc::Mesh& mesh);

}  // namespace ajar
