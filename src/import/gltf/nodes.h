#pragma once
#include <vector>

#include "import/gltf/accessors.h"

namespace ajar::gltf {

/// A node of the scene, with where it is.
struct PlacedNode {
  Element node;
  Mat4 to_world;
  bool is_visible = true;  ///< by its own word and that of those above (KHR_node_visibility)
};

/// All nodes of the scene that the file shows, parents before their children. Raises SceneError if
/// they are no trees.
std::vector<PlacedNode> place_nodes(const Element& root);

/// Where the mesh of a node is: in one place, or where EXT_mesh_gpu_instancing has it.
std::vector<Mat4> places_of_mesh(const PlacedNode& placed, Accessors& accessors);

/// Place and directions of a camera or a lamp, for which scale, shear and mirroring do not count
/// (glTF 2.0, section 3.10.2): z is kept, y where it can be. A matrix without directions is given
/// back as it is.
Mat4 without_scale(const Mat4& to_world);

/// `to_world` of cameras and lights along +z in a `SceneDesc`, and along −z in glTF.
Mat4 turned_around(const Mat4& to_world);

}  // namespace ajar::gltf
