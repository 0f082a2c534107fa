#pragma once
#include <map>
#include <string>
#include <vector>

#include "import/gltf/accessors.h"
#include "import/gltf/nodes.h"

namespace ajar::gltf {

/// Morph targets and skin of a mesh at one node. Sources: glTF 2.0, sections 3.7.2.2 (morph
/// targets) and 3.7.3 (skins).
struct Pose {
  /// Distinguishes the mesh from its copies at other nodes; empty if its vertices do not move.
  std::string name;
  /// Weights of its morph targets: missing ones are 0. Null: all are.
  const std::vector<double>* weights = nullptr;
  /// Transform of each joint, from the mesh as it was bound to the world; null without a skin. The
  /// place of the node is ignored with a skin.
  const std::vector<Mat4>* joints = nullptr;
};

/// The poses of nodes as the file places them: animations are not played. Poses refer to it.
class Poses {
 public:
  Poses(Context& context, Accessors& accessors, const std::vector<PlacedNode>& nodes);

  /// `mesh` is that of the node.
  Pose of(const PlacedNode& placed, const Element& mesh);

 private:
  /// Null if all are 0.
  const std::vector<double>* weights_of(const Element& holder);
  const std::vector<Mat4>* joints_of(const Element& skin);
  std::vector<Mat4> read_joints(const Element& skin);

  Context& context_;
  Accessors& accessors_;
  std::map<std::string, Mat4> places_;                  ///< transforms of nodes, by JSON pointer
  std::map<std::string, std::vector<double>> weights_;  ///< by JSON pointer of their owner
  std::map<std::string, std::vector<Mat4>> skins_;      ///< by JSON pointer
};

/// Moves the vertices of `mesh`, which has the attributes of `primitive`.
void apply(const Pose& pose, const Element& primitive, Context& context, Accessors& accessors,
           desc::Mesh& mesh);

}  // namespace ajar::gltf
