#pragma once
#include <vector>

#include "import/gltf/context.h"

namespace ajar::gltf {

/// A node of the scene, with where it is.
struct PlacedNode {
  Element node;
  Mat4 to_world;
};

/// All nodes of the scene that the file shows, parents before their children. Raises SceneError if
/// they are no trees.
std::vector<PlacedNode> place_nodes(const Element& root);

/// `to_world` of what looks or shines along +z in a `SceneDesc`, and along −z in glTF.
Mat4 turned_around(const Mat4& to_world);

}  // namespace ajar::gltf
